// SPDX-License-Identifier: MIT
// Made by tests/bench/fit_priors.cpp.
#include "core/runtime/format/coefficient_priors.h"

#include <array>

namespace mocapress::runtime {
namespace {

// clang-format off
constexpr std::string_view kContexts =
    "3FJKMOPSCFGIKJNVGGHILLQUEIGHILQUHKKIKMPWKMMMMMQWOSPOPPRWT[WUUSYX4EJIILOTIHHGGJLTJJJJKLOTHJ"
    "JIJKOVILKLMMPUNNNOONQWTTTSTSTXQ[XY][[Z:FKKIMNVIHGHHHLVNJKLKLOTHIIIIKOUKMMMMMQUPQQOQQTWUTVT"
    "UUVYV_WY[Z[_DGMMMLMWMFJHIKLVQJMMLLOTLLJKMNOTPMNNMNQVSURQPQTVZVUUUTVZf[aZ[][^KGMMKMOXMHJJLN"
    "OURLMLOOQXLKKLLMQVQMMKOPRWURQQPQTXZWTVSTUYh_]]][Z`NHNONPTaMJLLMOOZRJMNNQSZNKLNMPQ]PMPMPQRX"
    "UQQRQPTY_XVVTUVZi_bc^_[^QENOPSXiNJJNNPRYTMMLPRSXPLLMNRSZRPNPPQT^VPSRRRUZ]VWVUWW[gb_a_]]`^I"
    "NSU[bnMLMOQTY_XOMNPWY]RLNNOUX^SOQRRUX_YSVUXTV__YXZYYY]iid`_a`b==CCDEEO?@@@BBDQIEEEEFITDFDC"
    "DFJRKJIHIJLURPMNNMOT^SSUSTTYi eY[^_d:EGGHJLMEDDDDGHPKGFGHHLNEHCDEDHQHJIHGHJQMQKKHKMUOQMROQ"
    "PV      SR<GIIJLKPGHEFEGISJGIIGHLPHFGFHHJSGJIHIHLRMNLJKLLTQTOPOORW   IUXVW>ILKIJLPHFIHHHJS"
    "JHJJJIMRFHGHIJLRJKIIKKJSNMNKMLMUPRPOQNPVObULZXWXHINMLLMTJIKKJIMTNKILJMNQIKIJJKMSKKJKLMNROO"
    "PMMMOTSTSQOOPWV[^YXYW[KJOOOOQVLIKKLNPTNJMNNOPULJJLNOPUOLMMNOQTTQPOOORUWVSSSRSW_^[Z[YXYOIPP"
    "OSVZNJLJLPPXQLNLPRSXMLNLNRTUPNOOPQTWUQQRRSUV^VVTUTUWf_[[[[Z[THMOPPV`NKLMNPS[RKNQQRWXNLMMMR"
    "UZRPOOQRWXVRTTSRVY^UVVTVXZi[b^^]]^XHKLPTYfMLLOPRV[TMOMORW[SOOPQTV[UQQQRSX[XTTTTVYZ^WXWYYXZ"
    "jf]`_^]`@    cgg      bcW   VO``_   fYWd^  c[YYdm  RSW[bfd^ZY[^bl d[Zfbg2-8;<ADDGGIHJMPRTX"
    "ZZ^^^_fef     0,67:ABCEFGHHLQSUXY]^adegim     1-58;?ABGGHIJLQTVXZ[^aeeikmp    D.86:CBDFHJK"
    "KNQUUY[[_acgjmlyj   K08:;ADIIJLLONSSWX[^_bffjmotr   S:<<?FDGJKMLMORUWZ]]`behilosv   _<C=DF"
    "JJLLNNNORUXY]`acfhjmnsw   oHFMILMOQPRTQSUY[^^acefillopt   ;ILMMMYSW_DAEFFGJJLSHDHKHKROPSJH"
    "HJIIROOOMKKKKLSPSRUWPMOQVRUUUO PTQXSUV   MOUaUSV      hXWX      tXX^>ABBEG[LRZ=;C@ABADJJ?B"
    "DFJDKHOPEBADGDQHLOJBFDGIRGLMSVNLLJTLMPd  PMOXOOS    OOZOQT      cTTU      mYVXDD;;>>[LMV99"
    "D@>@ACEK@GCCDDLGJRCG?BEEQEFNB<AECDQDHLMc;JEGTGILO  UOOTKKO     P_OMQ      `SQR      eRRUM<"
    "  CAZJMS  EHC3ADDL;IH7:=NEFKF  8GGQIKKF  IAERFHJ9= 9=AP@DI    CJUIFL     PWMKM      ]OOP  "
    "    dRSS      WHIQ      <FNK     =S>@M    8;O;CK     >TDJL     HSAFK     BSFCH     DYJII  "
    "    XPLM      `WPQ      V:FR        S?      N EI      P<@J      O=;I      SI@M      RDAJ  "
    "    TCDG      YMHI      ZOKN      W ?R        <       L  I      L  G      O  L      K78I  "
    "    R8JK      P;FJ      S@?H      ZION      U  R                J  G      M  D      L  H  "
    "    L  J      L 8G      M HJ      N  J      W EMX<B?DIHHJIJKMPSUXY]_`aegilot{   _>?:?GFGKH"
    "KIIKNPRUWX[^acfjjop   Z<:E@GJJNNOMKGIKMQTUWX[_beikl   Y    FLJPPTSONKIIKMOSTVZ_afhl   U   "
    " ;GGJQTSPQOLKIKLMQRVX[bdi   S     QHLKTUOKNMMLJHKMMQTW]ac   S       NIRTSOJNLLMKIKLMMRV]b "
    "  R       HIMPSPIKMMKLLQJKNOOTR                                   OA@EFGFGGHHIJLMNOPQPQNOP"
    "POOL    Q<:;GEGJJGGJIHJLMNNOOOPPOPOPV   L    LGFKHNKKHGHJLMOOPPQPQPQS   K    WLNJOOMPILHII"
    "KLMONQOOPPP   J      JHKKNILJMKIHILJMOOPNPO   L       CHMMHLHLIJKIFJJKNOPPR   K       OIIM"
    "KLJJKIKKJJHJKKMMM                                                                         "
    "          M       JI      GHLJ    JHKKK   LJMLLLN LNNOMMN MMNMNMMNLLMNMMLLLLNLLMNMKKLMMNNO"
    "N       EH      CGKM    FIGJL   HIIHIKL KJKKJJN JLLMNNMPMLMMMNNOLMJMLMNLLLMLLLLNN       HI"
    "      EGLI    GFGMK   EEGGFKK GIHJKGK IHKJJILOILJLMMLNLMMKMMNNIJMMLMMMP       KK      GHMI"
    "    LDGLK   EHEHIOK EDFFHHJ JGIIJHGKGHIGLLJLLIMLKMMNNNIMOLMMM       JM        KF     JJLI "
    "  H<JGIKO =GCHIHL >GFDCGIKIGGHHKHHHCGHJJIKKLHLKKMMN        ;        FO      <KI      HIIM "
    "   D8FI   MHGELK; 9EHEEHM9MHHHJJOGHIHKLLL                 N        JI       GKK     <LI   "
    "  IIHK    K@HK    ;3DH OFJHJIJ                                PLJLNON WNOMOOObOOOKMNO IPNM"
    "NPRUOKOOLOPQJJMMLNOGKPLMJLORM NLLLOQJ NKLKOOO NNNLNQK JKKJLMJ KLKLMMNQMOONONNQNLMNMONPPSPN"
    "QPRQQNPMQNNOPPKJGOMJLJISVTTTQTVRNONOONOOOHJHMLJJKISUUSURTVSPOOMNOPOOLKHLLLMKHQUUPTRRSROOPL"
    "NNROPMLKLKMOLJPTSMRQQRQONQLNORPQNLMMMLPMMPQQMPQQPQNMPONLROTNMPLMMOOPPPPNNORQQNOPMMNQPTLOQJ"
    "ONOOSQMOLHORPPNONPQPLMNJQNRQMNQRJMPHPIMQMLQNSWPMRRTQMVNXKFIKMPRNKPOS.NOPRV`cl{,EFIKNWYi|4A"
    "DEIMWYe|;CEFKO[Zk|=EGHMQX`i|>KJKORWbm|=MOPQSUaj|A MQSUPdn|2ECAEH8MPiPPSTUX`]i|8DDEHJCTd|=H"
    "JJJN?VY[TRSTWYckp{FNMPQSM^i|                    8HEEFJWP]|                                "
    "                  0 <<=ESYdw,ACFLUaevu.QX[_en{xu                                        2 "
    " C@AMP_z- 8>CGSVk|+B@FJP[imy,FLQW^kv{z                              @   JLWVj|3  A@EOT]|/ "
    ">=CHTWk|/?CGMR`kp{+BFJQZg|||                    D    XOootC   PPYYl|/  BDGRTfv0 BCGLYao|2C"
    "CHPVcgo|0CHLQYgo||                    E    ZM`fnB   RR]^p|5  CFJTX`|5 KHKR_l||5FEKQZen{|4E"
    "HMT[jzy|                    D    ZN^hzA   PPXZgz9  NLQ]gs|9 KJMRat{|6EIKT`ryy|8NLPYasssx  "
    "                  A    [N]bq=   QP[^g|;  QPQ`bp|7 ONS[gyy|:MOQVprrsy                      "
    "        D    XRgn|A   OR^al{=  TWZfsz|5 MLS]rrsy                    ORNN#                 "
    "          HA)                             RUTTRPOONNNMLNOMJ8              OQQQPONMMNMMKJKP"
    "MK              Wjke_^[YVSRRRRPNJF=             V][ZYXWWVSQRRPSOLIH             PP^J&     "
    "      PRMO#                                                                               "
    "                                                                                          "
    "                                                                  M%              FC)     "
    "                                                                                          "
    "                                                                                          "
    "                                                    MSSSRPPONNNMMOOK<HHJJLKH        XKJJIM"
    "NMF       `WIKLKJLOI      e^XJIGJNPOI     ihc[HGHHMOI     migcZHEHLKM     rqjhbXGFGHF     "
    "urnigeYFFHL;    wuspkgb^FEGE    u{soohfaYFEFH   syyrooiebZFEG   xxxxppmggbYD@   uuuuuulimj"
    "_XC6  ooooooooofo^R3  cccccccccccccc< KQQQOONMNNMMLKMO@EFJLKHKJ       VOIFLKJJJ       _XMH"
    "HNRGHI      fb[MHJKPIE      igcZKHMLOF:     kjgcZKHMKPMI    okjfdZKINJMH    rnijecYKJLKMJ "
    "  snmigcaXIIONNF  |s{hjeb`XKINMN= yyyyfjgb`WKFPN< vvvvveed`^WIIPK rrrrrrrjf_dYHC  nnnnnnnn"
    "neeeW<  dddddddddddWQ   Wjke_^[YVTRRRRPL                                                  "
    "                                                                                          "
    "                                                                                          "
    "          V][ZXXWWVSQRRPSL                                                                "
    "                                                                                          "
    "                                                                                      MXPP"
    "#           SKNP#           SSLK#           ^RIP$           NSNI(           ILLB6         "
    "  PS@-            OW6;            KM%             A@,             LJ:6            FU,     "
    "        #               4                                               CB,             R>"
    "/             GV3             J-              )                                           "
    "                                                                                          "
    "                                                                          FSVWUTTUSRPPOPPL"
    "QRNQLKKOOOMQO   SRSOOILJLLKI    UTSSPQJKKKNI    XWTRQOQKJIML<   YYVTRQOQKLLMK<  Z]YUUSPOQK"
    "JD:   Zc]YUUTOORKJC   Ug_ZXXVUPOPJG8  Rfc^ZWWUSOPNIE  Qghc][XWTRNMJHM Qqij`[[XVSQLG7  Pqne"
    "lb[ZWUTNL>  Oluldi_^YUUSIG  Kessjgc]YWUSTOM;PSRRPPONNMMMMJMO?CEGIMMMI       UFGFGLPONO    "
    "  ZMIGHELOI       bVOIHFJIJQ      eYUOKIFJHOM     i_WVMKIHKKJ     jf[VUOJIJJ5     lfd]WUNI"
    "JIIG    lheb]XUPJLKJE   ongfc^YWPJLHF   pjpedb_ZWOLIHQ  yykheg`]ZUOJA   muildce_YWUPD:  rr"
    "rifcdc_[YXN@  llllcbblbXWj[VG ||qaWVSQPPOPPMMGridgigd`YVVUTTQMfffffffffVJ                 "
    "    MggggggROO      Nmmmnmm_LOC     N^nnnnnn]KPC    N_ooooof_VJLF   OppppppcXUUKNE  Tqqqrr"
    "riUQRWKO; U`rrekibbUOTUMPFTdfirc`^^_VOUVKIVqdbqqe^[^aTQUULVppbcppd`]^bTPROVooobbooc[]a_TMM"
    "[jsssjcdfda^[ZUMX^YZ[XVWWTRRRQTNBKXPOQA         UNYTLI          XXRPLMT;        [ZXZONNR9 "
    "      _beUXSQMP9      ZZ^aSSSPNP9     c_YWYUSRLNM<    cc_[WXUTSLNU;   mlc_bY[WLSLLM   ullt"
    "dba_[FMKM   ussehca`YZGSOOO srrrcs`gZZUGULO rqqrrbi`e[YSFN< ppppppppd`[ZUES<rrrrrrrrrrfrb]"
    "RL                5+              GP*             F[YB6           LdWK(           iTFR(   "
    "        T^LJ$           RHRU#           NXPR#           SSLL'           PNKV'           QS"
    "ON(           VKFB5           MF=6            |TA,            TK24                        "
    "                                                    )               H-              Jo3   "
    "          R$              CB,             Q@/             C6              N6              "
    "                                                                                FSUVTTUTRR"
    "PPOPPLLSOQLKKONONPQ   RRSOPJLJNKKH    UTSSQRJKJLNJI   XWTSRORKKJNG<   ZXWTSQOQKLKMK;  [^YV"
    "USPPRLKFH   Zd]YVVUOORLJB   Ug_ZXYVUPPPKH7  Rec^ZXXUSOPOIE  Pghc][XWTRNMKHM Qqhia[ZXWSQMG7"
    "  Pqndkb]ZWUTNK?  Nltlcl_^XTVSII  Jdrrifb^ZVUTTPM;                HNPPPPPPPOONLJMNGMLMLLLN"
    "MPMF    RONLLLKKIH:     XTOQMLLLMKE<    YZSPPMLLNLMJ:   ZbZUPRMKNMKKI   Zc_[TRROLLNKI<  Zf"
    "b^[SPRNMMMGE  Yfg`]ZURQNLMLF  UeicY]ZTPQNKKOF UficcZZXRQOMK?  TifgcaYZWSONLE  Sgggea^XZWRM"
    "LF  Riuddb`]UZVPMLF P]tkfb^]ZUTUVORO||qaWUSQPOOPPMMGridgigd`YVVUTTQMfffffffffVJ           "
    "          MggggggROO      Nmmmnmm_LOC     N^nnnnnn]KPC    N_ooooof_VJLF   OppppppcXUUKNE  "
    "TqqqrrriUQRWKO; U`rrekibbUOTUMPFTdfirc`^^_VOUVKIVqdbqqe^]^aTQUULVppbcppd`]^bTPROVooobbooc["
    "]a_TMM[jsssjcdfda^[ZUMfcXYTRQPQQQOPNRO[`deccba]VTUTRSMVZ^V]]adZQRXWVWLSSZTT]_eXPG<    S[W_"
    "_VW]YRRLI   RYZV]XUTZSQTK<  P_bXYZUVTZRRPH  Q^d_[XWVUSWSQSJ Qbi`ZZXVWYRZUN[HQ_heb[[XWUVUZT"
    "SMR^aeeb]ZXWSWR[RJQ`ahhq`[XYWUVRZJQ`pcgggcTZVTQWSRRbnnaendaWZZTTTPQ^kkkaakaYSYUNUQPakkkka]"
    "`j`WVYQE RLN>                            LA                              OMMMMMLMMLLKKNMOM"
    "               OMMMMMLLLLKLIJFIO               QQOPOONONNMMMLMMJ=              PMMNMMMMMML"
    "LMLNJJI                        @9DHJJLOQTTXZ[]b`dfcg           ?:CFFGKMQRUVX[Z_adcdi      "
    "     >=BFFHKNRTVWXZ^_bddgd           :?@DEHLOTUUXXZ]`ddhkd           :=DADHKQTVWXY[_`cgeic"
    "           9==DCGLOSUXY[]_aegfji           6:;@CGLOSWX[]^acdihkg           ;;?\?BFLNRWZ[_`a"
    "dghkpi   ;AFGJJIJHHHIJMNQUZ]_`cdfffhkt   EBGHIJIIGFIHKKPQTVW]_acefipkh   EDFDGGHGEIHHLOPRU"
    "UYZ^adfelllo   ACJBGIHGHIKLOQSUVWZZ]`eehjkjm   BCCCFMIIIKLLPSTUVZ[]_abfiklln   ?@DCFGOGILK"
    "OQSTUWY]^_cefilmmp   4EJGCGGHIQKNNQTVV[]^_beijllnn   MI FE5FGGJIVPQSTXZ]_bchglmlnpEEFEGDGE"
    "GEFHGHHILPQVY]__beefgkmrBBBBCCCCAGFEECFHILPQTW]]abfffdil@AABAAABCCECEGGHLMQSTYY^^cffgkljB@"
    "?@@@BB@FGFGIILOPTUXX[^abfgiiljH?@A?CCDBEEIJJLNQRTVY[]_`dfhjjpiAN=<ABDCBDIIHKLOQTTYZ]]_bceh"
    "iklk=<2@<?\?QECGILLLNSSUV[]]`aeiklkll<; B?ECCFCCXLLOPRTWX[]^adfhlmmjmCCADBACCCDEFHHGHJNOVXY"
    "[^`ccdmlmtB@@@@@BBBBDCDDFHJMPRVXY]b`b_cdqj==@><?>B@@@CCEEIKNPSVXZ`bcedcdch>A?>>?ACCDFDGFIL"
    "MQSTWYZ^adfefhfiB?>D?C@GFFGHFIKMQQTVXY]aacfjhigi>F>E@F@EHKIGIKLOQSVW[[[abdfijkgiQA=E=JBEEF"
    "GIMKLPRTVXZ]_`beghikkh5=7H>_CFIIKMMNOPSUXZ[]]ccfhijnkjAAACBACBBECFDFGJIOSUWYZ]^igefffk<?>@"
    "=>>@AABDCEEGHMOSVVZ[Z^]c`hYb:::<>><?A@BBCEEIJMQRVX]^]aec`n^d=?>D>CA@CCEDEGILMPSUWXZ]baceid"
    "cj>E<F>IH@DGEFHHKLORSVXZ^abcefgibh@FCG@JICGGHHIHKOPRVWY[]_bdefghdeHGAGDJIEHHJJJJNPQTVXZZ_a"
    "ccfgjmgeJM@WDHJGJMMLMMMOSUWZ[]_adfgimjlf<BAADDC?EEDEGGIKHNPTTVX   b     ;=;=?<@@CCABDFFIJL"
    "OTUW[XRZfU  bf9;:@A<>AABBCCEHIKNPSWYY_^]`ba_ha@CECBAAAACCDFHJKLPRUX[]a_cb`anbbBGFEGDFBGFFG"
    "GJKLNOSUYZ^`_bechjgaGGMEJHIEIGEGJJLLNSTWX[^`bbefcfahKJNCJIJEHJJJIKMMPTVWY]__adgfdkfeKIKKLI"
    "NJMLOLMNONQTVZZ]^bdfigglhdBF5ABEEGEEDHHGNLJTSWe           ?B<DB?ABBBFDFEHIIKPPUSOUc       "
    "8?>6=><?\?ABBFEFIKNRSVXZ[W`ZedQV >@G<>?BA@CFEFFGKLNQTVZ[[`[[d`X[aCAI@ECG@DFFEFFLKLPSUXZ]]b`"
    "``d__]HDKDJEFDHEGIHIKMMRTVZ[^^_dbddca^KGLELFIEHHIHIKKNPQUYX]_aaeegb_abNIPJNIKILKKMMKLPPSTX"
    "Z[_`bdegdgbf8IDLH<BCLGJJKNPPNPc             =78AB?@EBDCCEFHGJLNV O          ;C@>/<C@ECCCEE"
    "GJKMQSVXX^SVY     <BHEDDDBADBDFFJHMOQUV][]^XYUWRcUCAIAGADDFEEEGHHLKPRVX[_]`_c`_ihYCDKDH?FA"
    "GFHHHHKLLPSWX[^]a_]dca^`HEIDFGJDEGKFIHLMLRSUXZ_^ab`b^adbNNOLMHLGIKJJJKLMNRUXX[_`bea_bfbd=<"
    "< G << HE899E ;               @98DFHHFHKJBFJILJJ              ;>C>AA>?ADBAFFHLMPQQTTP     "
    "    DAFFFBC@DEDDDFIJLOSVVWWUVRSK  UUGACEGCGCGEEEEEJKLQSVX[Z[YX[TQdURFDJHGDGCEDEGHGJLLPTWY["
    "]^[[_ZXWZTHDLFGFGDEGIHFJKLMQTVZZ^___^_aW[VKGMLJCKGIJIIJJKMMPSVY[^]_^XY]eaUJFGFHGHHIHGIHGJK"
    "QWYYW][XV       FFDDDDGHIGHFGIHKOSVXX]^_c      OCCCDAADEHGFFGGHLOOUUX]Z_W       DAFC?EDGHH"
    "HGFHJMPRTVWYa`d      OJGGEDEFHGHIHGHLNOPTVVWXhe      JLEDCEBHEGJJKJIKNPSRSVW]b       LKB5F"
    "FGHGGKKJJHJNPRPRRSM        TLADJLHLHKLLJKKKNQQQSOQI        O564;:=>?BCDGIILMPSUWXZ]^aadegh"
    "gk7789<=@AEGHHIJLNPRSTWVZ]__bbfihk<9:;=?ABFGFGHJLMQSTUUWWVZ^_adegaB;<=A@BAHGHHIJKKSUUUVUUW"
    "YZZ_aca_C@?\?AAAFEGHGIIIMSUVVVWUUXX[Z[a^ZBB@BCDDDFGHIHJILSTUVVXWVYXYZ][`XCEDEEDGGGHGHFHILST"
    "WWVVVWXXYZ]ZXXFHFGHHHGIGJIGGHIRTVWWUVXWWUVVUUVLIIGGLJKLLKKKKJLMSVZUW          K<L?JHHJKIJJ"
    "LJJLOTVYWf          I= OKJHIHIHJLHIMOSUVUU          N J<FIDGIIGJLLJMNQTXSfc        FM  ICF"
    "FJKJKLNLKNNPTZUYb        QN   M<FIIIIJKJLNNRSVR          QL     LLJKJMNLLMOPRS           L"
    "P    <JOKNMLMMLNPPPP           NK     OVKGNLKMKMNQT             G        ILLKJLLNTV       "
    "      O       KLNKLLKMOPSW           OQ       :MMKMMLMMPUS           MR       INJKOPMMNPUQ"
    "           NR        MOKOMMMOPU            NQ       F NMONMMNO             NQ        KPLLK"
    "MNNMW            M#                                                                       "
    "                                                                                          "
    "                                                                                          "
    "    RRPQ#                           F0              C)              ywW&            |{g#  "
    "          ItR+            r,              y%              vFop1           mmmm3           "
    "vuvv+           xxwx*                                                                     "
    "                                                                      E6              56  "
    "            #               Q*              OR3             ND6             C1            "
    "  J-              BN3             C*              Q#              9F/             OD/     "
    "        I=6             Q#              N&              ;8              @.              95"
    "              ?1              =/              73              $                           "
    "                                                                                          "
    "                          ,               .B              9=NijjjO8       CCDVooooG6      "
    "IIFJKiqqhD6     ONLKFJiqrhC7    SRQLLCJ_pppF7   VURQMKDGXoooH7  W[SSQLKEDcmmcC< X`ZRSSKKDI"
    "^mmm; WdbXSTQMLFLYmmc;Wdf_YTVRMMDJakkOVggg`YTVSMODHggSVgkee_XUVTOMD5  Wkojgd`XTWSLJH7 Uinj"
    "ied_YTTSLKJ9Qgwigfa`]WUSOFM=Mnnen^neZYUNNK  5                                             "
    "                                                                                          "
    "                                                                                        ) "
    "              /6              69IMU           :@IPPL:         BBFIRNF<        IFGGHOPK8   "
    "    MKJHFGLPK9      PMNLIGHINL:     RPOOMKGIKRN8    TRQPPMKGJJOQ9   VWRSPPOKHLKVM9  VXWTRQ"
    "PNKHKLOQ; V^[XUTRQMKHKLRN<V`_]ZUSRSPLGJMRNWagb_ZVVTSOLJKGPVbhhbaZXVTSPKHNPR`ihidc]WUTPOEQM"
    "N_pgbddd_USWSP8 3                                                                         "
    "                                                                                          "
    "                                                                                          "
    "  ZpfTYp]NC7      ZfmgR]]_JA5     Xckf]S[V`I@5    Xeemd^SZY_IA6   XwhapabTZYaJB8  Wmvicnb_"
    "VZXdLD8 Wtttueud[X[[^JB<Vlttuidid`W[[aJFWttttuiiua]X][_HWrrrrrrbbf`[VXVPXnnnnnnnnbnXYQRR  "
    "                                                                                          "
    "                                                                                          "
    "                                                                                          "
    "                                                                TYWR[`[WJ2      TVWVTX[[WB"
    "2     UZWVWRT[]V@A    X^YXWXQS]]VF0   Z`_ZXVYRQZ[VH4  Yecd]ZXVRUZZXEE WhwedZX]XVVZZTE8Ydoj"
    "bd^]YXUV^YYDWhwojia]Y[XWWYZNXftttdab_ZXURPZRYdpppppppaVXRUVQ                              "
    "                                                                                          "
    "                                                                                          "
    "                              ";

constexpr std::string_view kTrust =
    "kgffdddefeeeddehfffggfeeeeeffffgdfeeefghcddcdegjaccbcdehgggegbegigdeedcdefeedddggfffgfefdg"
    "fffefheffegfhgefffffgjegeefggigggggfhiegdddccceeeeeddgefggggegeffffffgegfffgghdhfegfijdgge"
    "gfhjgggggeilafbccccbdfeeeddgcgfggffhdfffgffgcgefghgibefefghhbedegfhlgggggfhlagbcdccbddfeee"
    "egbgghhffhcheffgfgcegefgggabdefgijbcbeefglhggecfilahbcdccddigfgffhbggghfghcgfgghgicggggghj"
    "cffffgiifgdghgiljggghgklaibcccdgbhgfffegagfhggfibfefghhibfggigghddhhghhjfghhfgkkiggghfilbg"
    "cdeeglagggheegdghfffiidgfiggehdggfihhieheehijgfgghhilklggfggklfhffeeedegffedfgcefefefgdecd"
    "ddfhabccbdfgadcccbejbgggccfkg gggghllighfeefehgggigffhghhhghdgjfgheecccdegegafbbdcchggggfe"
    "bf      gglhggffedhfgggeggfgghfggheggfffggcgefffgfadbcdfefgfegbdbe   ggggbghgggfefgggggfgi"
    "ghhhggfifffgfghfeheffffhceddffegbgfbcbcdgggggfedaheggfefghigfffjgiiihgghfgghhggieghfgggjdf"
    "edeeghdgdcdcefggggfdfcagdefeeefgghhgggcgjhihgheihhhhgiehhgghhjdfeegfhicgdeeefhgggggcffafcd"
    "ddddeggggghhbijhihhhdggiihiiehihihjjchfhhikjfgefgghiiggggiilafcdeeeefggghhhichhghhhidhggij"
    "jieiiihijjdeiihjkkfhihhiklkgghgfjlafceeffleghfigjichjhhhilfghhijlkfghikjllegiihlllgheijkll"
    "kgghghllg    ggg      ggg   ggggg   ggggg  gggggg  ggghhgggggghkg ggggilllllllkjhihhiiijlj"
    "ihifggggg     lllllkkhhgggggikllllkkkhigg     lllllihhffeffgiklllllllllihg    allljfeeddcd"
    "degjllllllllllkgg   akjihedbbbabcdfilllllllllllgg   acifeabbaaabbdfhklllljllllljg   agbgba"
    "aaaaaabceghllllkllllljg   gfggeaaaaaabcdfghjllllllllljg   fccddffffgadehghhhfecdfeghfgefcc"
    "dfgiehfeebiggkdkhfgggcihdlligg gghckll   gggdjll      hdjl      kgelgddefedgffgdgfghhghgdf"
    "dcegfgefcegefhegeefggeghcigegggedebhhgg  gfgbhjh    ggdhjl      ghil      igelggggggcegegg"
    "gghghfhgfgggfdeeegfgghabdfgggggfgechgfgggghhbhhgg  gegbghh     geegh      fggi      fgfkgg"
    "  ggchee  gggggefgggggggegfhg  gfbdccjg  gggdeehgg gggdghg    ggdehh     gecfh      efdh  "
    "    fghl      cggd      gggg     ggggg    ggfghh     ggcbe     gdedf     gedeh     gfbdi  "
    "    egcg      egci      cggd        gg      g gg      gggg      fggh      hfef      cfbf  "
    "    dgeg      fgci      dggg      d gd        g       g  g      g  g      e  e      hggg  "
    "    ggge      cggf      dggf      dggf      h  f                g  g      h  g      h  h  "
    "    h  i      e gh      i gh      i  h      i gfdggggfggfffghjllllllllllllllg   hgggggcccd"
    "deghijllllllllllllg   gggggggfcbbceghijjllllllllllh   g    ggghgddeefghjjkllllllllh   g   "
    " gggggdcggeggfijkllllllli   g     ggggfdhfhfhgghjhlllllli   g       gggghfhgfgfhifjjjllli "
    "  j       ggjjjihhhihhgfhgkllll                                   gggghhjjkllllllllllllljj"
    "hhhg    gggggggghfhijlllllllllljkiigg   g    gggghgghhkkllllllllljkhg   g    ggggfhgghhjjk"
    "llllllllkgg   g      ggggfghgehijkllllllljg   g       gghggggggdhiljlllllif   g       gggh"
    "gfgfhghhiklllllli                                                                         "
    "          l       lj      iili    llllk   lkllllh lllllll kllllllihhkjkllkihiihklkghgiihll"
    "l       gh      ihke    giiih   jiijkji jikllll kjlllllihhjkllllhgfhklllefhhiiklk       hg"
    "      fghg    hghig   hggghih fghihjk ghhkklljhejkklllggiijlllgggfgillj       gg      gggg"
    "    ggghg   gggfhjg eghghij fgggjijigfgghkllggghhhllgghggillj       gg        gg     gggh "
    "  ggggfhf gggghgi gggggfigggggfigjgggfgdilggggghllk        g        gg      ggg      gghg "
    "   gggi   ggggfhg gggghiggggghgjggggfghll                 g        gg       gfg     ggh   "
    "  gghh    gghj    ggfi ggggfhl                                ghllllj gghllllgggilllj gghl"
    "llkggghjlllgggghlllgggdilllgg dikllgg fhillgg fgillgg ggilljg fgeklhlihkjgjgjedbhicdfddced"
    "dfedjlfgiighfkefcgidfgddcffeggdjlffgjihgkdecfieefedceeeggeileefihgglcfcchedgedceeegdehleef"
    "ghegicecbfeefdcceddhcdhlfeffgfejcfbbeeefccbfcchcefldedcfgdicebbdfdfccbfbbhceelgefdggfeddbd"
    "ejckdfchbcdehdlldedfilhhijklhiffkiiigglkgjjllhjlggkkggkhlhfgillkjigijaaaaaaadglaaaaaaadglc"
    "aaaaaaagkbbbaaabbgjcdbaaacbghffcbaadhghghfeaadggg ghgdadgglbbdbafaggdebfbffagglaaaaaebdgjd"
    "fcecdfggcfggcehdgfgdbcbbbdeg                    ggggggihgg                                "
    "                  k fgbbbeegigdaaaaaggjaaaaadggg                                        k "
    " ggdbdfgl gebaabggkgdaaaaegglbaaaadfgg                              i   ggdcggl  ggfcbcgl "
    "gfbaaabglgdabbacgglcaaaadggg                    i    gbgggj   gecdhgl  gbbccbgl hgeaadgglg"
    "fdbabcgglbaaaaehgg                    h    gafggi   gdddggl  gdbccbgl fcabbggglggdbbbfggib"
    "ecbaeggg                    h    gahggg   fcbchgk  fcbbgggl gfbacggglgfeeggggghfgggggggg  "
    "                  h    gahhgg   fabffgh  ghbbcggl gfeeeggghggggggggg                      "
    "        f    hagggg   gabeggh  gggggggi gggggggg                    jhclg                 "
    "          jfg                             acddcccccdddidhggg              abcccccccddddhhg"
    "gg              lhghiigfbabbceegggg             fccecbbbcaaaaaabfgg             llilg     "
    "      kgblg                                                                               "
    "                                                                                          "
    "                                                                  kg              lgg     "
    "                                                                                          "
    "                                                                                          "
    "                                                    acccccdefhjiighhfddfgggg        hffggg"
    "ggg       igdggggggg      jhheggggggg     ihhgdgggggg     ihhhgdegggg     hfihghbgggg     "
    "hgghgehcgggg    gggghfhffggg    ggggghgghfggg   ggggggggggfgg   gggggggggeggg   gggggggggf"
    "gghg  gggggggggggggg  ggggggggggggggg abbccccceeffeggheccfggggg       ddcdefggg       hfdb"
    "dggggg      hgeccegggg      gihfcbfgfgg     ghighdcbgfgg    fghihhcbcggg    gghghegbdeggg "
    "  ggghgihgcggggg  ggggghhhhefgggg gggghgghhhbfggg gggggggggfgeggg ggggggggggggeg  gggggggg"
    "ggggfg  ggggggggggggg   lhghiigfbabbceei                                                  "
    "                                                                                          "
    "                                                                                          "
    "          fccecbbbcaaaaaah                                                                "
    "                                                                                          "
    "                                                                                      llfl"
    "g           jldag           gjbag           lajjg           kealg           lhfgg         "
    "  ljig            jhgg            khg             gig             bhgg            agg     "
    "        g               g                                               lig             ja"
    "g             ghg             gg              g                                           "
    "                                                                                          "
    "                                                                          eddddddddefghghh"
    "dhefcggfggggg   dhefdcfggggg    chedeeffgggg    cegececeggggg   bdeedcfcfffggg  bdedddcfcf"
    "ggg   bgfdcdcbfdegg   adheeeedcdfegg  aggfdecdcagdgg  aghggfddbebdggg aggfghefebddeg  aggg"
    "fehhdfeggg  aggggggghegggg  agggggggggggggggabbccccccdddfhghecghggggg       ddgggggggg    "
    "  ddchgeggg       ddddgggggg      dcdccehgggg     fdccccehggg     egccdbbefgg     ffgcdcbb"
    "bggg    chehccddbbggg   gggfecdecadgg   gegfgedebbbfgg  ggeehfecdbbef   ggggghffebedgg  gg"
    "gggfggggffag  ggggggggggggggg ggggggggggggggggggggggggggggggghggggggggggg                 "
    "    gggggggggg      ggggggggggg     gggggggggggg    ggggggggggggg   gggggggggggggg  gggggg"
    "ggggggggg ggggggggggggggggggggggggggggggggggggggggggggggggggggggggggggggghgggggggggggggggg"
    "ggggggggggggggghlgdgebbbcccceggiggggggg         gggggg          gggggggg        ggggggggg "
    "      gggggggggg      ggggggggggg     ggfegggggggg    ggfgcgggggggg   gggfgfggggggg   gggg"
    "ggggggggg   gggggfgeggggggg ggggggegfgggggg gggggggfgfggggg ggggggggggfggggggggggggggggggg"
    "gh                ag              agg             hgagg           lgakg           jaigg   "
    "        iacag           llhig           llflg           jkjag           fiaag           lc"
    "jkg           hghbg           khgg            gjig            cjag                        "
    "                                                    g               gg              ggg   "
    "          kg              lig             fgg             hg              gg              "
    "                                                                                edeedccddd"
    "efhghhdiffdggfggggg   dgfffeghgggg    cheddgggggggg   cegecdeffgggg   bceddcddgggggg  bded"
    "ddcdegggg   bgfdcdcbdffgg   adhededdccgfgg  aggfdeddcafdgg  aghggfdebfceggg aggfggefebdefg"
    "  agggfeggefdggg  aggggggghfgggg  aggggggggggggggg                dbccccbbcdcbcgggdcefecff"
    "gggg    dgdddecgggg     dfgefddcfggg    cfefefdcfgggg   cheedfgbgdggg   begfefefdegggg  ai"
    "effdddfccggg  agffhffeecbggg  adhfdfgeecabcgg adfhedhgddgggg  aggffedefhdggg  afgggfgeheef"
    "gg  aggggfgfggggggg aaggggggfgfgggggggggggggggggggggggggggggggggggghggggggggggg           "
    "          gggggggggg      ggggggggggg     gggggggggggg    ggggggggggggg   gggggggggggggg  "
    "ggggggggggggggg ggggggggggggggggggggggggggggggggggggggggggggggggggggggggggggggghgggggggggg"
    "ggggggggggggggggggggghgdbfgcbbecebaeggfdggggggaaaaaafgfggggggggggggggggggggggggggg    fggg"
    "ggggggggg   eggghggggggggg  agggghgggggggg  agggfgggggggggg agggggggggggggggaggggggggggggg"
    "ggegggggggghggggggeggggggfggggggggagggggggfgggggggegggggggggggggggggggggggggggggggaggggggg"
    "gggfffgg leil                            fg                              ijhhgjhfhfggggggg"
    "               ljklkkhiigeecgggg               gggggggfafgfffgggg              hggggggfdfg"
    "ggggggg                        kllllljhhgeeffdhfhheg           lkllllkkjhgfggeefigeh      "
    "     ljlllllkkiihghgefgdge           lklllllkjjiiihhhhjihd           lllllllkjjjijkkjikfic"
    "           lllhjlkjlklllkljilfjf           kijiigihihikljljhjhjd           hhgigfeghikjklk"
    "ljkhlh   ggefgfghhhijijiigihgfgfficgfg   ggghgggiilllllllllljjgjhfhggc   gfhhhghgjllllllll"
    "kjkljjkhiigg   ghbiiiijhjlllllllllklkklljhii   ghehhhhhhiljkllllllllklllljij   gggfiidhhkj"
    "jlklllllllllklkikk   gggghgggidgjjlkkjklllllljkhih   gg ggggghfhfjjlkljjkllllllhgkgeddddde"
    "fgijllliklhjiigidghhcgggfgedfgghiilllllllkkikhiighfhdgffihffhghhjikklllllllkklikjihhgghdff"
    "ehgiehhhikkkklllllllllllliggheadfdgfhhfjggiiikjllklkllllljkhgghaghdhgegehhhjkjllllklllllkk"
    "ieheggggggfaggfdghgkjkljkklllkjjkgiggg ggggggggaehhillljkkllllllljigdfefefgijiiijkijfkhhig"
    "ffcgggggggeggghghjijkkklkljjjikjjhihgfggggfighhgiijilkkklklkjkljhiijhggggghggehhhfijjjkllk"
    "kllllljkkkiihghhdfgfhgheehighjkllllllllllljhhhgghfgegghefbghhgjjkllllllllllkjgggaggggfgeff"
    "edfhghkiljllllkkkkjhffgggggfggdfegegiiilllkkllllljjificgfgfhdhhiiigjhgchihhdcgggggggggefgg"
    "ggjjiiijjijjghhhiihhhfggggggfhhghhhiikjjiljikjkjkkhhggfgggggecfchbehgjiijkkljlklkllijihhgg"
    "fghagcfbaifffhiijkilllljkkljijfgehefgegacebgeghhihikllllllkjihighfgfgggfdgfefhegfghjkjlklk"
    "kiighggeggggggegfcfighhjikiklkkkkjigjhgdfgggefgghegfghghdgggggg   g     gggghghhhihfiihihh"
    "hhhggggggg  ggghgggfhghfiikijiikjjihjihffgggggaggeehgggghgjlkkiliklkiighggggggaaegacbfcfgh"
    "hiijjlilllljifhggggfeeefaacfbhgghgjjjjlljlllkihgggggagggffcgcbdfgfghjjkkkjjkijhhhgfhfgfggg"
    "fgfcdfgfjkikkkljljljihhggdggggggggggggfgggdgggg           gggggggghhfhhhighhhgggggg       "
    "gggggggghgiiijjjihighgggggggggg bgfgefhhfigihijjkjjkijhhffggggggagggcfghgefhhigjhklllgjigg"
    "ggggggdffgfddfecdghhgjhlllllkkiihhggggfgfgfgggfgcghgghjjklkkjjiiifgggfggegbfgecffeghjjhkjl"
    "kjiikihhhgghggggggggggggggggggg             ggggggggggfgggfhggfg g          gggggggggehihf"
    "fgfhhhggggggg     ggfgggfhgfhhigikgggkghiggfggggggfgggggfhfhgiihjijjiiihjhhgggggggfgfgfgff"
    "gghgfihhikkiijjhhffggggggggggfegeggegghhhjlkkhkiifhgggggggbgfgdfgfgfhihijjjkkjjhiigggggjgg"
    "g g gg gggggg g               gggggggggggggggggg              ggggggggggghhghghhhfggg     "
    "    ggefggdgghhgggihhhjhgghggggg  ggegggfdahfgghggigijjhhgfeffggggggdgfcegehgefegigikjlkji"
    "jigfgggggidgfecfbgffggghgjkljjjijhfggggggjcgfghheiefggijlllllkjjgihgfgggglfhhdfhjighhkllll"
    "gighggggg       igfhhggihijlllllliifegggg      ghggghfiiijjklllllkhdhgggg       gggghhhjih"
    "kkllllligfcgggg      gdgggggehgijklllllkhfggggg      ghgggggehiihijlllligggggg       ghggg"
    "ggggghgjkllllicgggg        gfggggggghgfihklllgggggg        gghhgffhhhhkjllllllljjihhhiiiih"
    "hjfhghggffffhhillllllihggggfgefgggbghgfgefggghjlllllljhgfffdehhggaadhdcffgdggijlllllljihgf"
    "febedfaaabdbddedfhghllllllliihgffedabcdaaaecccfgfggjjlllllljjhggggbdddbabefecgcdfefjhlkllk"
    "kiijhfdddfeeedhggffghgfghhiikillljhgeeggfgggfghggggggghghhilllhhgggg          hgggggggggfh"
    "illllihfgg          eg gggghhgfilllllihggg          g gggggghggikllllihgggg        gg  ggg"
    "ggfhhhillllihgggg        gg   gggggfggillllhggg          gg     ggggghhjkllgfg           g"
    "e    gggggghhilllhgg           gg     gggggghilljgg             g        ggggilllfg       "
    "      g       gggggillligg           gi       gggggilllkgg           ik       ggggggllllgg"
    "           ij        ggggilllkg            ll       g ggghklll             ll        gggfi"
    "lllkg            lg                                                                       "
    "                                                                                          "
    "                                                                                          "
    "    igblg                           gg              gg              gggg            gggg  "
    "          iggg            gg              gg              ggggg           ggggg           "
    "ggggg           ggggg                                                                     "
    "                                                                      gg              hg  "
    "            g               ig              chg             agg             gg            "
    "  hg              hhg             lg              ig              kfg             ghg     "
    "        lgg             kg              jg              gg              ag              fg"
    "              jg              ig              hg              g                           "
    "                                                                                          "
    "                          h               jg              efggggggg       beffgggggg      "
    "adcbagggggg     acdaaagggggg    aeecaaegggggg   agefcaaagggggg  affffcaafgggggg ahfgefcbaf"
    "ggggg ahiggegcaafgggggahhghhegcbagggghahghigifgcbaggghahghfhihffcbcg  aighfhiiihgccgg ahgh"
    "gggiigheheggahggghhhhihghgggagggggggfggggg  g                                             "
    "                                                                                          "
    "                                                                                        i "
    "              jg              gdggg           ebggggg         ccabgfgg        acfbaefgg   "
    "    addfabaggg      adedeaaefgg     aceeddcafggg    aceeedcaefggg   adcfedecbafggg  adddgf"
    "ddcdbgggg aedddffeddbbggggadgedegfdfceggggaegfedfhgefcggggacgihgdehedfcfggachhgfifdihefhgg"
    "adggggggdgggggg g                                                                         "
    "                                                                                          "
    "                                                                                          "
    "  hggggggggg      iggghhfghgg     iggghhgefhgg    igggghhgcghgg   igggghhhgcgggg  iggggggh"
    "hgfghgg iggggggghgggfhgghggggggggghgeghgiggggggggghhggfhhgggggggggggggfhhggggggggggggggh  "
    "                                                                                          "
    "                                                                                          "
    "                                                                                          "
    "                                                                geghgfggfg      gehhhfgheg"
    "g     gddhhfdggbfg    febehhfafhffg   ffdgbhgfbfhegg  hhfdccghfeggffg gggfgbghggeggfggffgg"
    "dfcdhhfbghghgfgggeebgggffgghgfggggeegfhgefghgggggggggffgdfgh                              "
    "                                                                                          "
    "                                                                                          "
    "                              ";

constexpr std::array<std::int16_t, 216> kWeights = {
    103, 561, 476, 307, 307, 307, 307, 307,
    257, 322, 294, 43, 257, 79, 348, 307,
    203, 323, 302, 56, 265, 152, 254, 307,
    204, 338, 283, 75, 272, 178, 232, 307,
    269, 273, 272, 75, 288, 219, 197, 307,
    336, 206, 264, 64, 309, 216, 193, 307,
    369, 152, 282, 42, 344, 206, 200, 307,
    370, 88, 265, 37, 361, 185, 213, 307,
    303, 83, 237, 66, 292, 166, 262, 307,
    269, 339, 182, 276, 204, 219, 307, 307,
    294, 317, 191, 290, 196, 225, 307, 307,
    311, 294, 175, 312, 192, 217, 307, 307,
    346, 299, 176, 334, 204, 210, 307, 307,
    323, 328, 200, 345, 199, 200, 307, 307,
    328, 314, 212, 373, 200, 194, 307, 307,
    305, 301, 227, 429, 194, 191, 307, 307,
    358, 313, 78, 516, 207, 181, 307, 307,
    312, 302, 291, 197, 192, 307, 307, 307,
    447, 422, 225, 203, 277, 179, 217, 307,
    37, -44, 415, 630, 663, 307, 307, 307,
    36, 94, 273, 287, 472, 307, 307, 307,
    -87, 500, 138, 150, 516, 307, 307, 307,
    -183, 328, 424, 261, 463, 307, 307, 307,
    -80, -121, 308, 310, 531, 307, 307, 307,
    6, -11, 383, 208, 321, 307, 307, 307,
    354, 326, 188, 176, 307, 307, 307, 307,
    349, 163, 184, 307, 307, 307, 307, 307,
};

constexpr std::array<std::int16_t, 1280> kWeightsByScale = {
    11, 100, 55, -344, -46, -188, 62, 0,
    -31, -42, -43, -100, -2, -378, 42, 0,
    -72, -93, -108, -88, 35, -220, -61, 0,
    -134, -81, -151, -27, -168, -65, -23, 0,
    -163, -106, -98, -34, -135, 44, -40, 0,
    -141, -106, -24, -68, -147, 23, 2, 0,
    -68, -44, -4, 5, -69, -46, -50, 0,
    -54, -49, -67, 13, -88, -32, -38, 0,
    -2, 205, 34, -351, -86, -72, 10, 0,
    -11, -38, 14, -148, 59, -354, -40, 0,
    -130, -58, -119, -115, 72, -264, -121, 0,
    -207, -140, -68, -94, -102, -96, -104, 0,
    -210, -132, -49, -146, -194, 47, -85, 0,
    -111, -93, -20, -142, -100, -9, -73, 0,
    -141, -75, -23, -167, -82, -10, -42, 0,
    -70, -90, 4, -117, -82, -38, -65, 0,
    -16, 200, 62, -346, -90, -89, -29, 0,
    -28, 36, -58, -169, 51, -312, -72, 0,
    -131, -101, -87, -168, 40, -274, -107, 0,
    -226, -96, -54, -134, -139, -80, -94, 0,
    -177, -75, -102, -140, -109, 5, -98, 0,
    -90, -78, -39, -163, -77, -2, -85, 0,
    -29, -64, -43, -228, -79, -22, -45, 0,
    -82, -62, 13, -180, -79, -45, -47, 0,
    41, 132, 70, -325, -99, -101, -51, 0,
    -5, 4, -33, -187, 80, -275, -114, 0,
    -25, -86, -112, -182, 42, -282, -125, 0,
    -45, -124, -137, -172, -118, -64, -122, 0,
    -127, -102, -55, -180, -79, 17, -113, 0,
    -89, -51, -2, -244, -64, 20, -99, 0,
    -62, -46, -18, -305, -56, -10, -63, 0,
    -85, -105, 4, -300, -23, -10, -30, 0,
    103, 150, 79, -314, -136, -95, -17, 0,
    125, -154, -12, -262, 110, -303, -150, 0,
    58, -106, -125, -190, 29, -252, -136, 0,
    22, -111, -115, -197, -114, -87, -114, 0,
    -64, -91, -102, -214, -79, 4, -96, 0,
    -72, -68, 3, -260, -47, 0, -89, 0,
    -61, -75, -21, -270, -39, -10, -39, 0,
    -42, -60, -10, -241, -48, -34, -40, 0,
    166, 139, 7, -336, 7, -140, -89, 0,
    158, -216, 94, -314, 141, -307, -140, 0,
    99, -169, -142, -209, 101, -266, -160, 0,
    61, -169, -51, -193, -178, -153, -53, 0,
    18, -141, -99, -229, -71, 12, -103, 0,
    -64, -109, -49, -246, -40, 4, -66, 0,
    -57, -101, -7, -224, -37, -15, -54, 0,
    -66, -96, -32, -267, -31, -12, -17, 0,
    174, 233, 52, -144, 67, -164, -129, 0,
    95, 130, -20, -261, 267, -366, -188, 0,
    65, -293, 29, -260, 171, -357, -135, 0,
    128, -253, -34, -217, -174, -192, -23, 0,
    38, -152, -94, -242, -81, 0, -96, 0,
    -19, -132, -86, -300, -38, 2, -56, 0,
    -20, -97, -67, -272, -25, -8, -31, 0,
    -41, -65, -11, -244, -31, -12, -33, 0,
    -217, 195, 81, 175, 50, 17, 27, 0,
    -311, 202, 67, -168, 281, -217, -6, 0,
    -255, -35, -150, -206, 253, -333, -206, 0,
    30, -303, -26, -251, -185, -272, -14, 0,
    62, -214, -126, -210, -71, -54, -39, 0,
    14, -137, -38, -207, -61, -17, -29, 0,
    30, -93, -57, -263, -23, -3, -33, 0,
    21, -66, -13, -154, -22, 2, -36, 0,
    -194, 86, 170, -40, -144, -105, 0, 0,
    30, 68, -188, 44, -193, -107, 0, 0,
    -29, -121, -154, -112, -256, 0, 0, 0,
    -5, -123, -145, -52, -120, -83, 0, 0,
    -46, -1, -124, -2, 16, -135, 0, 0,
    -52, 69, -74, -41, -7, -102, 0, 0,
    -46, 99, -47, -62, -18, -101, 0, 0,
    -55, 57, 44, -58, -43, -63, 0, 0,
    -96, 312, 131, -128, -22, -228, 0, 0,
    28, 197, 124, -14, -118, -94, 0, 0,
    128, -22, -150, 26, -136, -87, 0, 0,
    83, -78, -127, -44, -308, 23, 0, 0,
    -23, -146, -124, -38, -169, -62, 0, 0,
    -41, -30, -109, -1, 10, -158, 0, 0,
    -14, 57, -115, -7, 7, -148, 0, 0,
    -85, 95, -73, -46, -22, -97, 0, 0,
    130, -97, -159, 388, -82, -246, 0, 0,
    88, 42, 62, 55, -32, -224, 0, 0,
    242, 15, -25, -37, -117, -65, 0, 0,
    209, 34, -198, -5, -148, -94, 0, 0,
    49, -86, -151, -7, -222, -42, 0, 0,
    -3, -137, -140, -22, -126, -95, 0, 0,
    -49, 0, -118, 6, -14, -156, 0, 0,
    -75, 89, -83, -17, 4, -136, 0, 0,
    56, 43, -4, 228, -167, -77, 0, 0,
    -40, -146, -64, 125, -69, -209, 0, 0,
    -51, -122, 98, 70, -38, -130, 0, 0,
    192, 65, -113, -57, -71, -94, 0, 0,
    226, 27, -172, 2, -140, -94, 0, 0,
    76, 20, -134, 3, -193, -53, 0, 0,
    6, -111, -120, -16, -154, -83, 0, 0,
    -99, 29, -127, 45, 33, -192, 0, 0,
    23, -20, -60, 149, -7, 0, 0, 0,
    -82, 97, -7, 133, 3, 1, 0, 0,
    -201, -32, -28, -12, -133, -27, 0, 0,
    -165, -35, 2, 85, -51, -155, 0, 0,
    191, 35, -98, -30, -85, -119, 0, 0,
    216, 65, -64, 3, -135, -93, 0, 0,
    94, 75, -106, 4, -186, -67, 0, 0,
    -45, -40, -110, 62, -5, -175, 0, 0,
    -109, -81, -7, 63, 0, 0, 0, 0,
    -202, -204, -8, 111, 0, 0, 0, 0,
    100, 3, -19, 152, 5, 0, 0, 0,
    -305, -42, 107, 174, -242, -141, 0, 0,
    -36, 73, 93, 14, -58, -117, 0, 0,
    251, -79, 43, 30, -79, -152, 0, 0,
    291, 97, -85, -9, -137, -87, 0, 0,
    -25, -3, -101, 75, -89, -120, 0, 0,
    12, 22, 0, -3, 0, 0, 0, 0,
    -58, -34, 0, 28, 0, 0, 0, 0,
    -254, -203, 0, 91, 0, 0, 0, 0,
    -112, -49, -10, 72, -122, -8, 0, 0,
    -147, 165, 88, 283, -142, -122, 0, 0,
    -30, 118, 35, 163, -27, -148, 0, 0,
    275, -4, 88, 3, -78, -155, 0, 0,
    49, -5, -91, 98, -123, -105, 0, 0,
    -30, -41, -107, 24, 0, 0, 0, 0,
    -53, -14, -200, 29, 0, 0, 0, 0,
    -121, 71, -155, 92, 0, 0, 0, 0,
    -87, 69, -271, 55, -4, 0, 0, 0,
    -147, -26, -328, 79, -125, -61, 0, 0,
    -9, 156, -245, 220, -161, -103, 0, 0,
    107, 326, -326, 158, -103, -29, 0, 0,
    99, -96, -45, 184, -90, -125, 0, 0,
    171, 88, -104, -104, -169, 0, 0, 0,
    47, 5, -9, -150, -111, 0, 0, 0,
    -17, -8, 21, -60, -138, 0, 0, 0,
    8, 30, -33, -124, -93, 0, 0, 0,
    -40, 4, -3, -96, -105, 0, 0, 0,
    -4, -61, -39, -117, -87, 0, 0, 0,
    -35, 1, -48, -96, -111, 0, 0, 0,
    -18, -77, -47, -93, -81, 0, 0, 0,
    205, 220, -109, -131, -150, 85, -175, 0,
    256, 122, -163, -76, -209, -25, -90, 0,
    253, 133, -132, -67, -102, -116, -67, 0,
    184, 140, -117, -69, 11, -146, -71, 0,
    116, 96, -73, -102, 36, -162, -79, 0,
    56, 72, -40, -127, 3, -161, -80, 0,
    46, 72, -27, -102, -7, -172, -89, 0,
    41, 97, -6, -152, 27, -184, -92, 0,
    243, 6, -156, -188, 0, 0, 0, 0,
    186, 54, -164, -185, 0, 0, 0, 0,
    93, 55, -120, -149, 0, 0, 0, 0,
    101, 81, -110, -137, 0, 0, 0, 0,
    11, -1, -100, -93, 0, 0, 0, 0,
    -15, -27, -74, -108, 0, 0, 0, 0,
    -30, -79, -59, -100, 0, 0, 0, 0,
    -48, -88, -69, -79, 0, 0, 0, 0,
    147, 8, 47, 0, 0, 0, 0, 0,
    19, -97, -166, 0, 0, 0, 0, 0,
    94, -72, -152, 0, 0, 0, 0, 0,
    218, -112, -123, 0, 0, 0, 0, 0,
    137, -104, -51, 0, 0, 0, 0, 0,
    53, 17, -109, 0, 0, 0, 0, 0,
    -135, 31, -69, 0, 0, 0, 0, 0,
    -100, -148, -89, 0, 0, 0, 0, 0,
};

constexpr Confidences kConfidences = {{
    {{{256, 208, 376, 184, 184, 150, 221, 295},
      {256, 260, 313, 197, 319, 323, 298, 310},
      {256, 220, 345, 305, 245, 217, 266, 313},
      {256, 256, 256, 256, 256, 256, 256, 256},
      {256, 256, 256, 256, 256, 256, 256, 256}}},
    {{{256, 151, 356, 273, 265, 201, 211, 200},
      {256, 208, 345, 287, 237, 211, 227, 262},
      {256, 173, 289, 252, 244, 239, 215, 218},
      {246, 194, 199, 197, 205, 232, 239, 235},
      {256, 256, 202, 171, 224, 232, 231, 238}}},
    {{{256, 285, 326, 385, 274, 216, 160, 116},
      {256, 256, 149, 238, 254, 256, 299, 196},
      {247, 269, 231, 163, 138, 130, 161, 191},
      {257, 207, 172, 179, 206, 230, 247, 236},
      {256, 256, 256, 256, 256, 256, 256, 256}}},
    {{{256, 256, 256, 231, 249, 250, 244, 251},
      {256, 256, 256, 222, 269, 281, 235, 245},
      {256, 256, 231, 204, 215, 201, 231, 274},
      {256, 256, 256, 256, 256, 256, 256, 256},
      {256, 256, 256, 256, 256, 256, 256, 256}}},
    {{{256, 256, 361, 341, 272, 260, 268, 265},
      {256, 256, 256, 315, 239, 294, 303, 262},
      {211, 247, 229, 228, 248, 284, 302, 282},
      {198, 231, 258, 294, 309, 242, 221, 254},
      {256, 148, 149, 138, 158, 208, 246, 331}}},
    {{{256, 192, 197, 214, 200, 206, 209, 214},
      {256, 235, 271, 249, 186, 306, 286, 189},
      {257, 153, 325, 274, 210, 253, 167, 231},
      {256, 207, 345, 275, 229, 280, 248, 190},
      {271, 349, 331, 277, 292, 325, 301, 101}}},
    {{{256, 256, 256, 274, 282, 300, 238, 269},
      {256, 256, 256, 260, 256, 220, 252, 265},
      {256, 256, 256, 256, 256, 256, 256, 256},
      {256, 256, 256, 256, 256, 256, 256, 256},
      {256, 256, 256, 256, 256, 256, 256, 256}}},
    {{{256, 256, 256, 256, 272, 232, 262, 268},
      {256, 256, 256, 256, 256, 256, 256, 256},
      {256, 256, 256, 256, 256, 256, 256, 256},
      {256, 256, 256, 256, 256, 256, 256, 256},
      {256, 256, 256, 256, 256, 256, 256, 256}}},
}};
// clang-format on

}  // namespace

std::string_view context_priors() {
  return kContexts;
}

std::string_view context_trust() {
  return kTrust;
}

std::span<const std::int16_t> weight_priors() {
  return kWeights;
}

std::span<const std::int16_t> weight_priors_by_scale() {
  return kWeightsByScale;
}

const Confidences& confidences() {
  return kConfidences;
}

}  // namespace mocapress::runtime
