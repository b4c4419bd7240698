// SPDX-License-Identifier: MIT
// Made by tests/bench/fit_priors.cpp.
#include "core/codec/format/coefficient_priors.h"

#include <array>

namespace mocapress::runtime {
namespace {

// clang-format off
constexpr std::string_view kContexts =
    "3FKKNOPSCEGIKKOWFGHILMRVEIGHILRUHKKJLMPWKMMMLMQWOSPOQPRWT[WUUSYX3EJIJMOTHHHGGKLTIJJKKLPUHJ"
    "JIJKOVJLKLMMPUNNNONNQWTTTSTSTXQ[XY][[[9FKKIMOVHHGHHILVNJKLKLOTHJIIJKPUJMMMMMQUPQQOPQSWTTVU"
    "UUVYV`WY[Z[^CGMMMLNWMFJHIKLWQJMMLLPTKLJKNNOTQNNMLNQVSURRPQTUZVTUUTUZf[aZ[]Z^JFLMKNOXMHJJLN"
    "OVRLMMOOQXLKKKLNQWQMMKOQRWTQQQPQTXYWTVRTUYh_]]][Z`MHNNOPTbLJMLMPOZQJMNOQS[MKLNMPR]OMPNPQRY"
    "UQQRQPTY^WVVTTV[h_cc^_Z_PENPPSXiNJKNNPRYSNMLPRSYOMMMNRT[QPNPPRT^VPSQRRU[[VWVUVW[gb_a_]]`^I"
    "NTV[bnMLMOQTZ_XNMNPWY]RLOOPUX^SPQRRUX_YSVVXTV__YYZYYY]iid_`a`b<>DCEFGO>?@@CCEQGDDDEGJTCEDC"
    "DFJRKIHGHILUQOMNMMNT^SSUSSTYi eY[]_c:EGGIJMMDDDDDGIPIGFGIHMNEGCDEEIQHJIHGHKQMPJKHJMUOQMROQ"
    "OV      SR<GIIJLLQFGEFFGISIGHJHJMQGFFFIHJSGJJHIHMRMMKJKKLTQTOPOOQW   IUXVW>ILKIKMPGFIHHHJT"
    "IHIJKJNRFHGIJJMSJKIIKKKSNMNKMLMUPRQOQNPVObULZXWXIJNMLLNUJIJKKJNTNKILJNOQIKIIJKNSKKJKLLNRNO"
    "OMMMOUSTSROOPWV[^YXYWZJJPOOPQWLIKKLNPTMJMNNOQVKKJLNNPVOLLMNOQTSQOONORTVVTSSRSW_^[Z[XXYNJOP"
    "OSVZNJLJLQQYQLNLORSYMLNLNRTUPNOOOQTWTQQRRSTV^WUTUSUWf_[[[[Z[SIMOPPV`MKLMNPS[RLNQQRWYMLMMMR"
    "U[RPOPQRWXURTTSRVY^UVVTVXZi[b]^[]^XHKLQTYfMMLOPRV[SMNMORW[SOOPQSV[TQQQRSW[XTTTSUXY]WXWYYWZ"
    "je]`_^]`@    cgg      ccV   VO``_   fYWd^  c[YYdm  RSW[bfc^ZY[^bl d[Zfbf2-9;<AEEIHJHKMPRTX"
    "YZ^^^_fef     1,67:ABDEGGHHKPRUXX]^adegim     2.48;>ACGHHIJLQSVWY[^aeeikmp    D-769CBDFHJJ"
    "KNQUUX[[_acgjmlyj   J07::ADIHJLLONSSVX[^_befjmotr   S9<<?FDGKKMKLNQTWZ]]abehilosv   _<C<DF"
    "JJLLNNNORUWY]`acfhjmnsw   oHFMILMOQPRTQSTYZ^^acefillopt   ;ILMNMXSW_DBEFGGJJMSHDHKHKROPTIH"
    "HJIIROONMJKKKLSPSRTWONOQUSUUUO PTQXSUV   MOUaUSV      hXWX      tXX^=AAAEG[LRZ<;C?AA@EJJ?B"
    "DFIDKHOPEB@EGDQILOIBEDGIRGMMSVMLLJTLNPd  PLOWOOS    OOYORS      cTTT      lYVWDD;;>=ZLMV99"
    "D@>@ACEK@GDCDCLGJRCG?BEDPDFNA<ADCBQCHLMc;JEGTGILO  UONTKKO     P_NNQ      `SQR      eRRUM<"
    "  CAZIMS  EHC3ADDK;IH7:=MDFKF  8GGQIKK<  IAEREFJ9= 9=AP?CI    CIUIFL     PWMLM      ]OOP  "
    "    dRSR      WGHQ      <FNK     =S>@M    8;N;CK     =TCJM     HS@FJ     BSECG     DYJIH  "
    "    XPLM      `WPP      V:FR        S@      N EH      P<@J      N=;H      SI@L      RDAJ  "
    "    TCDG      YMHI      ZOKN      V ?R        <       L  I      L  G      N  L      K78H  "
    "    Q8JK      P;FI      S@?H      ZION      U  R                J  G      L  D      L  H  "
    "    L  J      K 8G      L HJ      N  J      W EMX;B?DIGIJIKLNPSUWY[^``dfilot{   _>@<?GFGKG"
    "KIJLOPSUVXZ]`beiiop   Z<:E@GJINMNMKHJKNQTUWWZ^adikl   X    FLJPPTSOMKIJLNPSTVZ^`fgl   U   "
    " ;FGIQSSPPOLJIKMNQSVXZadi   S     QHLKTUOKNLMKJIKNNRTW[ac   S       NIRTSOJMKKMKIKLMNSV]b "
    "  R       HIMOSOIKMMKLLQJKOOOTR                                   OA@DFGEGGHHIJLMNOPPPQNOP"
    "POOL    Q<:FGFGJJGHJJIKLMNNOOOPPOPOPV   L    LGFKHMJKHHHKLNOOPPQPPPQS   K    WLNJOOMOILHIJ"
    "LLNONPOOPPP   J      JHKKNILJMKIHILKMOOPNPO   L       CGMMHLHLIJKIFJKKNOPOR   K       OHIM"
    "KLJJKHKJJJHIKKMMM                                                                         "
    "          M       JI      GHLJ    JHKKK   LKMLLLN LONOMMM MMNMNMMNLMLNMMLLLLNLLMNMKKLMNNNN"
    "N       EH      DHKM    FIHJL   HIJHIKL KJKKJKN JLLMNNMPMLMMNNNOLMKMLNNLLLMLLLLNN       HI"
    "      EHLI    GFGMK   EEGGGKK GIIJLGK IHKJKILOILJLNMLNLMMKMMONIJMMLMMMP       KK      GHLI"
    "    LDGLK   EHEHIOK EEFFHHJ JGHIJIGKGHIGLLJLMHMLKMMNNNIMNLMMM       KM        KF     JJLI "
    "  H<JGIKN =HCHIHL >FEEBGHKHGGHHKHHHCGHJJJKKLGLKKMMN        ;        FO      <KI      HIIM "
    "   D8FI   MHGELK; 9EHEEHM9MHHHJJOGHIIKLLK                 N        JI       GKK     <LI   "
    "  IIHK    K@HK    ;3DH OFJHJIJ                                PLJLNON VNOMOOObOOOKMNP IPNL"
    "NPQUOKONLOPQJJMMLNOGKPLMJLORM NLLLOQJ NKLLOOO NNNLNQK JKKJLMJ KLKLMMNRLOOMOONQNLMMLONPPSPO"
    "QPRQQNPMQNNOPPJIFOMJKJHTVTTTQTWRNONOONOOOHJHMKJJLISVUSURUVSPOOMNOQOOLKHLLKMKIQUUPTRRTROOOL"
    "NNROPMLKLKMOLKPSSMRQRRQONQKNORPQNLMLMMPMMPQQMPQQPQNNPONKROTNMPLMMOOPPOPNNORQQNOPMMNRPTLOQJ"
    "ONOOTPNOLHORPPOOMPQPLMNIQORQMORSJMPHPIMQMLQNSXPNSRTQMVNXKFIKNPQNKQOS.MOPRV`cl{,EFIKOXZi|4A"
    "DFINXYe|;CEGKO[[k|=EGHMQXaj|>JJKORWbn|=MOPQSTak|A MPSUPdn|3ECBEH8MPiPPSTUX`]i|9CDEHJCTd|=H"
    "JJJN?VY[TSSTWYckp{FNMORRM^j|                    8HEEGJWP]|                                "
    "                  0 <<=ETYdw,@CGLUafvu-QX[_eo{xu                                        1 "
    " B?BMP_z- :>CGSVk|*B?FJOZimy,ELQW]kv{z                              @   JLWVj|3  A@EOT]|/ "
    ">=CHTWk|.<CGMR`kp{+BFJPZg|||                    D    XOootC   PPZYl|0  BDGSTfv1 BCGLYao|2C"
    "CGOVcgo|0CGLQXgo||                    E    ZM`fnB   SR]]p|5  CFJUX`|5 KHKR_l||5FEKQYen{|4D"
    "HMTZjzy|                    D    ZN]hzB   OPXZgz9  NMQ]gs|9 JJMSat{|6DIKT`ryy|8NLPXasssx  "
    "                  B    [N]aq>   PPZ^g|;  QQQ`bp|7 ONS[fyy|:MOQVprrsy                      "
    "        D    XRgn|A   PR]ak{=  SWZfsz|5 MLS]rrsy                    PQNJ#                 "
    "          F>)                             SVUTRPOONNNMLNOMJ8              QQQPOOMMNNMMKJKP"
    "MK              [jle__^ZURPQQQONJF=             V^]ZYYXXVRQRQPRNLIH             WMbH&     "
    "      RROQ#                                                                               "
    "                                                                                          "
    "                                                                  M$              E@)     "
    "                                                                                          "
    "                                                                                          "
    "                                                    SUTRQPOONNNNMONJ<GGIILKJI       TIIIHL"
    "MLH       [UHIKIJLOI      c^VIHFIMPOI     hgaYGEGGMOI     mjgbXFDGLKM     sqigaWFEFHF     "
    "tunigcWEEGL;    xvspkgaZDDFE    u{toohf`XEEFH   syyroojeaYEDG   xxxxppmggbYC@   uuuuuumimi"
    "_XC6  ooooooooofo^R3  cccccccccccccc< PPPPOOMMMMMMLKMO@DFHJJGKJ       TLIFKJIJJ       _ULH"
    "GLPFHI      f_XLHIJOHE      id`WKHMKOF:     lidaXJHMKPMI    okidcXJINJMH    snijdbWJIMJMJ "
    "  snligb`WHIONNF  |s{ijeb`WKINMN= yyyygjgb`WJFPN< vvvvveed`^WIIPK rrrrrrrjf_dYGC  nnnnnnnn"
    "neeeW<  dddddddddddWQ   ]jle__^ZURPPPQOK                                                  "
    "                                                                                          "
    "                                                                                          "
    "          V^[ZYXXXVRQRQPRL                                                                "
    "                                                                                          "
    "                                                                                      OWQQ"
    "#           RLOR#           TSLK#           ZSJP$           NTOJ(           KMMB6         "
    "  ORC-            PY6;            MM%             BA-             MK:6            HV,     "
    "        #               4                                               CA,             O<"
    "/             DU3             G-              *                                           "
    "                                                                                          "
    "                                                                          ERUUSRSUSRPPPQOK"
    "LQMPLKKOONMQO   PQRMNHKILLKI    STSRPPIIJKOI    UXTRQNPIIIML<   WYWTRPNPJKKMK<  X_YVURONQK"
    "ID:   Xd]ZUUSNNRKIC   Ui_ZYXUTNOPIG8  Sfc^[XXURNPOIE  Rghb][XWSRNLJHM Rrik`[ZXWSQLG7  Qqne"
    "lc[YWUUNL>  Pmumdi`^XUUSIG  Kessjgd^YWUSTOM;NQPPONNMMMLLMJMO?CEGHLLLI       UFGFGKPNNO    "
    "  [NIHHEKOI       bUOIIFIIJQ      fXTOJIFIHOM     i^WUNJHHKJJ     je[VUOJHIJ5     lfc]XUOI"
    "IHIH    lgfb]XUPJKKJE   oohgc^YWPJKHF   pjpedb_ZWOKIHQ  yykhfga]ZVOJA   muimdde_YWUPD:  rr"
    "rifcdc_[YXN@  llllccblbXWj[VG ||rbXWUSRQPQPNMGriehigeaYTTSSSQLfffffffffVI                 "
    "    OggggggROO      Pmmmmmm`KNC     P_nnnnnn]KPB    P`ooooof_VILF   QppppppcWUUKME  Uqqrrr"
    "riSORWKO; VarrejibbSMSUMPFUdfjrc`_^`UNTVKIWqdbqqe^]_aRPTULVppbdppd`]_bSORNVooobbooc]]a_SMM"
    "[jsssjcegea_][ULW`Z[]YWXXRQQQPSMCLXPPPA         UNYTKJ          XXRPMMT;        [[XZONNR9 "
    "      _beVXSQMP9      ZZ^aTTSQNP9     c_YWZVTRKNN<    cd_[WYUTSLNU;   mld_bZ]XLSLLM   ullt"
    "ebb`]ENKM   tttehda`ZZFSOOO srrrdr`gZ[VFULO rrqrrciaf]ZSEN< ppppppppd`[ZVDS<rrrrrrrrrrgrb]"
    "RK                4+              HQ*             G]YB6           MdXL(           hUHR(   "
    "        S]LJ#           QJRW#           NVQR#           SSMM'           QNKW'           QT"
    "PN(           VLGB5           OG=6            |SE-            UL24                        "
    "                                                    *               E-              Io3   "
    "          P#              CA,             N>/             @5              L6              "
    "                                                                                DQSTSSTTSR"
    "QPPQOKJSMPLKKONNNPQ   ORTOOIKJNLKH    STTSPQIJJLNJI   UXSSQOQJJJNG<   WXWTSPOPKLKMK;  Y_YV"
    "UROORKKFH   Xe]YVUSNORKIB   Ui_ZXYUSNPQJH7  Sed^ZXXTSNPOIE  Qghb][XXSQNLKHM Rqhj`[ZXWRQLG7"
    "  Pqndlc[YWVTNK?  Oltlcl_^XTVSII  Kerrjgc^ZVUTTOM;                ELNOOONOOOONLJMNHMKLLLLM"
    "MPMF    OONLLKKJIH:     UTOPMKKLMJE<    VYRPPLLLNLLI:   X]XTPQMKMMKKI   XbYYTQQNKLNKH<  Zd"
    "b]ZROQNMMMGE  Zeh`ZZTRQNLLLF  VegbY]YSPQNKKOF WfiacYYXRQOMK?  VifgdbYZXSONLE  Uhgfea^XZWRM"
    "LF  Sjuddc`^UZVPMLF R^tlgc_]ZVTUVORO||rbXWUSRQOQPNMGriehigeaYTTSSSQLfffffffffVI           "
    "          OggggggROO      Pmmmmmm`KNC     P_nnnnnn]JOB    P`ooooof^VILF   QppppppbWUUKME  "
    "UrqrrrriSORWKO; VarrejibbSLSUMPFUdfjrc`_^`UNTVKIWqdbqqe_]_aRPTUKWppbdppd`]_bSORNVooobbooc]"
    "]a_SMM[jsssjcegea_][ULeeY[TSQPQRRPPNRO[`eecccb]USTSQSLVZ^V]]beZORXWVWLSS[TT^`eXOF;    S[W_"
    "_WX]ZQRKI   SYZV]XUU[SQTJ<  PabXY[UVTZQROH  R_d_]XWVUSWRQSJ Qbi`ZZXVWYSZUM[HR_heb[[XWUVUZT"
    "SMR^afeb[ZXWTWS[RJQ`ahhq`]XYXUVRZJQ`pcgggcTZVTQWSRRbnnaendaWZZUTTPQ^kkkaakaYSYUNUQPakkkka]"
    "`j`WVYQE RLN>                            LA                              OMMMMMLMMLLKKNMOM"
    "               OMMMMMLLLLKLIJFIO               QQOPOONONNMMMLMMJ=              PMMNMMMMMML"
    "LMLNJJI                        @;FJIKLOSUUW[][addfbf           A<EGFHKMQRUUY][^`dddf      "
    "     @?DFFHLNRUVVX[^^beffd           <ABEEHMPTUUVW[^adehjf           <>FAEHLPTVWWXZ_aehgkc"
    "           ;>=DDHLPTTWX[]_ceiflh           7<=@CGLPSVWZ^_bbegilh           9=>?CFLNRWZZ^ba"
    "ehihpj   ;ADGJJIJKKLNLPQQWZ[__dfffhnpp   DEIGIKIHGIKILLPQTUW]^aefejhse   EDEFHHHFFJGLMNQRT"
    "VY]]aehikkjo   BCJCFIHGIKKNQQSUVVY[]cdfjkmmn   DBEDHNIIIMLNOSUUVYZ]^`cgkkmmn   >@DDGFPHJLN"
    "PRTUUWX]_^begjnpmo   =DIEFGGGIPMNORTVVY[^_cehjnnnn   OG HBBFGIHKWPRSSWXZ_adgijlmmpEFFHGFFE"
    "GHHIHJKKNQSVX]_`bdgmcqjlCDDBCDDCGEGGEFFIKMPQVX]]acfdgghj@BBCBCBCCBECEHHIMMPUUYY]`dgffhglB@"
    "@AABCDAEEGGIILOQSUXXZ_bdeijijkHAA@BAEEBFFIKKMOPSTVY[[`_dhhkkmjANA?@ADDEFHJILMPRUUYYZ]_adfh"
    "jnlk?<@@9<AQEDHIMMMPSSUVZ][baeiiknrn<: AAFCD@FFXLNPQRTVYZ]]adfhlkmkoCDCDBDCDDDFGHJIKJNQVWZ"
    "Z]b`enmikqBA?ABBBCCBDEEGGHJNPSUXZ^]c`d`fqt=>B>?>@@@A@DDEFJLNPRWY[`_cfeaghg?@<?@@?ECDFDGGIN"
    "MPTTWYZ_bcfhgfhiC@@E@DBEGHGGFJLNQQTVW[]_`dfjjhfi@F>GBE@DIKIJHKMORTUXZ[Z`bffikhjjPD=DBIBEFG"
    "HILKMPSTVXZ^^`bghfjhnh5A7HA^AFHKKNMNPPSUWZ[]]bdhiimhjj@CDDBB@CBFFEGGIJIPSTXXZXVfeg cdh=?=>"
    ">@A@AACDEDGHILQRUVY]ZXd`^fYl<:=;>>>?AAACCFFIJMPTVZ][^`d`obdf=?=F=AB?CEFCGFILNPTUWXZ_abfdhi"
    "fh?D:G<IG?FFFGHHKMORSVY[^_befegehhAEAHCJICHIHIIHKPQRVWZ[^``dghgjegHGCI@IJGGHJKKKNOQTUXZ[^a"
    "cdhhkiheIOEVBHKGKLMLNMNOSTWZ]Z_bdfihmojg?C@FACCCCEEFFHJKGNRTQRSc        ;<@>>A@@ACAEEGGHKL"
    "PUUVYZRNdc   f<<@==>?A@BCDCFHIKNPTWYY^[_a^hhd^@BECCACB@CCCGHKKLPRUX]]`aa`damkaCFFCFDECFGEG"
    "FJLMOPSVY[^_adcdhea_GGLEIHJEGFEHJJLMOSUXX[^`bdgegcdcKJMCMHJCHJLIHLNMPUWVY]``bcgfdggeKIKLLI"
    "NKMMOMMMOOQTVZZ[_beehhiidd@F6I>GEHEFCJHJGNJUQX            >BCBB>A@CAFEFFHIIKQPUSe   c     "
    ";><?>;@>?AACFFEJLNRTUZYY[^fMc  b?<F@AAA?BCDFEGHKLOQUVZ[]^]_aggi^C@H@FDFADEFEHFMKLPTUX[]_``"
    "ca_j^^IDJCJEFEGFHIIILMMRUVZZ^`_efc_`[`LILHKFICHHIHJKLOPRVXY]_acffc_daaOIOKNIJJLKLMLLMPPSUX"
    "Z]__begfefbf@GHIBGK9JKKOHRNKOS              ?6A@B@B@DBCEEFHHIONQ            ?:<?A@B@DCDDDF"
    "HJJMQSWYVZc       @CGEECC@BECEEGJIMNRUW]Z`[[URSV XBBHCECDCFFEEFHIMLPSVY]]]``fc^X^YDGJDGBGA"
    "GGHHIHKLLPTWZ]]]_^`c_[[_HEICGGJCFFKGIHLNMRSVX]_``bab^bmcNNOKNFMHILIJJLLMNRUXY[_badb`_bgd;<"
    "<H <; ME7;:;B=                BDED?EHHFHJFFIHJME              ;@H>9@C?BCCCCHHLMORSUP      "
    "    CCGFECCCBEDDEFIKMOSWWZVSTRIY   WGEBEGCGCEFDEEFKLLPTVX[[Z]WUSSS UGCIIIBGCDDFFHHKLMQTWY["
    "[_]`_WWZSUHEKHFEHDEHIHGJKMMRTWZ[^_`]aZX`]VKGMLJCKGJKHIJJLNMQTVX[_]^]]Z]_]UIHGGGEGIIIIKJGKL"
    "PYY[[[g         GDFEECGHIHGIJIIKPTUYZaYe        DBDDCCEEGHHFGGIMOPUWZ_X[        DEACDEEEGH"
    "HEGHJMPSTV[Z`c       OJDEGDEHFHIHGHILOORUVUZWdc      MKBEFD@HFHJJKKILOPQSUUUT        LKFEH"
    "GEIGHJLKIHKOPRQPOFU        PLACHMIMIKLLJKLKOPQPQPR         O5569<=>?ADEEIILNPSTVX[[`acedhh"
    "ik8769<=>?CGIIJKLNPRRUTYZ]_^cbhhjj<8::=A=CDFHGJLLNPRSUUVVX[^_aecdg@><=@CADEGHIIKKMRSTUUTVW"
    "ZZ]]bac_CA>@BCCBFFHIIJJNSTUUVTTVXWYZ]a]YBDC@BEEHFEIIIHJMRSUWWXUWWYXY[^]WDDCGDGGHFGHIIGHMSU"
    "WVVWVVWXXYXXYXHGGGHHGIHHHJIHHIRTVVVTWUVUUTSVTVMLHIIJIKKLKKLKKMLUYcb           KO KIIHKKKII"
    "LJJLOTW]Y           K9 BIIJIJIHKKHIMNUVVW           NI HEKGFKIIIMKJMNRV[WM         QM  ;FG"
    "KJHKKLNMKNNRUWTb         ON  <MMIHIHHKJJKONRRV           QN     DNIJJMNLLNOQRS           P"
    "O   I<JMOMNMNMLNPOPR           OL      MPLKJLMMMNUK             I     G  JLLKKLMNSY       "
    "      L     I< LINMLKMNOS            QP       LLKKNMMMNQS            NQ       JKJKNQNMNOV "
    "           MQ     II GNNOMMMOO             OP       :<OMNOMMNO             NQ       IQPLKL"
    "MONNW            M";

constexpr std::string_view kTrust =
    "kgffdddefeeeddeifffggfeeeeeffffgdfeeefghcddcdegjadcccdehgggegbegigeeedcdefeedddggfffgfefdg"
    "fffefheffegfhgefffffgjegeefggigggggfhiegdddccceeeeeddgefggfgegeffffffgegfffgghdhfeffijdgge"
    "gfhjgggggeilafbcccbbdfeeeddgcgfggffhdfffgffgcgefghgibefefghhbedegfhlgggfgfhlagbcdccbddfeee"
    "egbgghhffhchegfgfgcehefgggabdeffijbcbfefglhggecfilahbcdccddhfggffhbggghffhcffgghgichgggghj"
    "cffffgiifgdghgiljggghgklaibcccdgbhgfffegagfhggfibfffghghbfggigghddhhghhjfghhfgkkiggghfilbg"
    "cdeeglagggieegdghfffiidgfiggfhdgffihhieheehhjgfgghhilklggfggklfhffeeedegffedfgcefefefgdecd"
    "ddfiabccbdfgadcccbejbgggcbfkg gggghllighfeefehgggigffhghhhghdgjegheedccdffegafbadcchggggfe"
    "af      gglhggffedhfgggeggfgggfggheggffgggbgefffgfadbcdfefgfegbdbe   ggggbghgggfeegggggfgi"
    "ghhhggfifffgffhfeheffffgdeddffegbgfbcbcdgggggfedahfggfefghiffffjfjiihgghegghhfgifghfgggjdf"
    "edeeghdhdcdcefggggfdfcagdefeedfgghhgggcgjhihgheihhhhgiehhgghhideeegfhicgdefefhgggggcffafcd"
    "ddddeggggghhbijhihhhdhgiihhiehihihjjdgfhhikjfgefgghiiggggiilafcdeeeefggghhhhchhghhhiehggij"
    "jidiiihijjdfiihjkkfhihhhklkgghgfjlafceefflfghfigjichjhhhilfghhjjlkeghikjllegiihlllgheijkll"
    "kgghghllg    ggg      ggg   ggggg   ggggg  gggggg  ggghhgggggghkg ggggillllllljjhihhiiijlj"
    "ihifggggg     lllllkkhhgggggikllllkkkhigg     lllllihhffeffgiklllllllllihg    allljfeeddcd"
    "degjllllllllllkgg   akjihedbbbabcdfilllllllllllgg   achfeabbaaabbdfhklllljllllljg   agbgba"
    "aaaaaabceghllllkllllljg   gfggeaaaaaabcdfghjllllllllljg   fcdddffffgadehghhheecdfeghfgeecc"
    "degiehfecbiggkdkhfgggcihdlligg gghckll   gggdjll      hdjl      kgelgddefedgffgdgfghhghhdf"
    "dcegfgefcegefhegeefggeghcigegggeeebhhgg  gfgbhjh    ggdhjl      ghil      hgelggggggcegegg"
    "gghghfhgfgggfdeeegfgghabdfgggggfgfchgfgggghhbhhgg  gegbghh     geegh      fggi      fgfkgg"
    "  ggchee  gggggefgggggggegfhg  gfbdccig  gggdefhgg gggdghg    ggdehh     gecfh      efdh  "
    "    fghl      cggd      gggg     ggggg    ggfghh     ggcbe     gdedf     gedeh     gfbdi  "
    "    egcg      egci      cggd        gg      g gg      gggg      fggh      hfdf      cfbf  "
    "    dgeg      fgci      dggg      d gd        g       g  g      g  g      e  e      hggg  "
    "    ggge      cggf      dggf      dggf      h  f                g  g      h  g      h  h  "
    "    h  i      e gh      i gh      i  h      i gfdggggfggfffghjllllllllllllllg   hgggggcccd"
    "deghijllllllllllllg   gggggggfcbbdeghijjllllllllllh   g    ggghgddeefghjjkllllllllh   g   "
    " gggggdcgfeggfijkllllllli   g     ggggfdhfhfhghhjhlllllli   g       gggghfhgfgfgifjjjllli "
    "  j       ggjjjihhhihhgfhgkllll                                   gggghhjjkllllllllllllljj"
    "hhhg    gggggggghfhijlllllllllljkiigg   g    gggghgghhkkllllllllljkhg   g    ggggfhgghhjjk"
    "llllllllkgg   g      ggggfghgehijkllllllljg   g       gghggggggdhiljlllllif   g       gggh"
    "gfgfhghhiklllllli                                                                         "
    "          l       li      iili    llllk   lkllllh lllllll kllllllihhkjkllkihiihklkghfiihll"
    "l       gh      ihkf    hihih   jiijkji jijllll kjlllllihhjkllllhgfhklllefhhiiklk       hg"
    "      fghg    gghig   hggghih fghihjl ghikkllihejkklllggiijlllgggfgillj       gg      gghg"
    "    ggghg   gggfhjg eghghij fgggjikigfgghkllggghhhllgghghillj       gg        gg     gggh "
    "  ggggfhf gggghgj gggggfigggggfigjgggfgdilggggghllk        g        gg      ggg      gghg "
    "   gggi   ggggfhg gggggiggggghgjggggfghll                 g        gg       gfg     ggh   "
    "  gghh    gghj    ggfi ggggfhl                                ghllllj gghllllgggilllj gghl"
    "llkggggjlllgggghlllgggdilllgg dikllgg fhillgg fgillgg ggilljg fgeklhlhhkjgjgiedbhicdfddced"
    "dfedjlfgijghflefcgidfgddcffeggdjlffgjihgldecfieefedcedeggeileefihgglcfcchedgedceeegdehleef"
    "ghegicecbfeefdcceddhcdhlfeffggejcfbbeedfccbfcchcefldedcfgdhcebbdfdfccbfbbhceelgefdghfeddbd"
    "ejckdfchbcdehdlldedfilhhijklhiffkiiigglkgjjllhjlggkkggkhlhfgillkjigikaaaaaaadglbaaaaaadglc"
    "baaaaaagkbbaaaabbgjcdbaaacbghffcbaadhghghfeaadggg ghgdadgglbbcbafaggcebfbffagglaaaaaebdgjd"
    "fcecdfggbfggcehdgfgdbcbabdeg                    ggggggihgg                                "
    "                  k fgbbbeegigeaaaaaggjaaaaadggg                                        k "
    " ggdbdfgl gebaabggkgeaaaaegglbaaaadfgg                              i   ggdcggl  ggfcbcgl "
    "gfbaaabglgdabbacgglcaaaadggg                    i    gbgggj   gecdhgl  gbbccbgl ggeaadgglg"
    "fdbabcgglbaaaaehgg                    h    gafggi   gdddggl  gdbccbgl fcabbggglggdbbbfggjb"
    "ecbaeggg                    h    gahggg   gbbchgk  fcbbgggl gfbacggglgfeeggggghfgggggggg  "
    "                  h    gahhgg   fabffgh  ggbbcggl gfdeeggghggggggggg                      "
    "        f    hagggg   gabeggh  gggggggi gggggggg                    jhclg                 "
    "          jfg                             acddcccccdddidhggg              abcccccccddddhhg"
    "gg              lhghiigfbabbceegggg             fccecbbbcaaaaaabfgg             llilg     "
    "      kgblg                                                                               "
    "                                                                                          "
    "                                                                  kg              lgg     "
    "                                                                                          "
    "                                                                                          "
    "                                                    acccccdefhjiighhfddfggggg       hfgggg"
    "ggg       ifefgggggg      jhheggggggg     ihghdgggggg     ihhhgdegggg     hfihghbgggg     "
    "hgghgehcgggg    gggghfhffggg    ggggghgghfggg   ggggggggggfgg   gggggggggeggg   gggggggggf"
    "gghg  gggggggggggggg  ggggggggggggggg abbccccceeffegghecceggggg       ddcdffggg       hfdb"
    "dggggg      hgeccegggg      gihfcbfgfgg     ghighdcbgfgg    fghihhcbcggg    gghghegaceggg "
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
    "dhefcggfggggg   dhefdcfggggg    chedeeffgggg    cegfceceggggg   cdeedcfcfffggg  bdedddcfcf"
    "ggg   bgfdcdcbfdegg   adheeeedcdfegg  aggfdecdcagdgg  aghggfddbebdggg aggfghefebddeg  aggg"
    "fehhdfeggg  aggggggghegggg  agggggggggggggggabbccccccdddfhghecfhggggg       ddgggggggg    "
    "  dechgeggg       dddcgggggg      dcdccehgggg     fdccccehggg     egccdbbefgg     ffgcdcbb"
    "bggg    chegccddbbggg   gggfecdecadgg   gegfgedebbbfgg  ggeehfecdbbef   ggggghffebedgg  gg"
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
    "efhghhdigfdgggggggg   dgfffeghgggg    cheddgggggggg   cegecdeffgggg   bceddcddgggggg  bded"
    "ddcdegggg   bgfdcdcbdffgg   aehededdccgfgg  aggfdeddcafdgg  aghggfdebfceggg aggfggefebdefg"
    "  agggfeggefdggg  aggggggghfgggg  aggggggggggggggg                dbccccbbcdcbcgggdcefdcff"
    "gggg    dgdddecgggg     dfgefdddfggg    cfefefdcfgggg   cheedfgbgdggg   begfefefdegggg  ai"
    "effdddfccggg  agffhffeecbggg  adhfdfgeecabcgg adfhedhgddgggg  aggffedefhdggg  afgggfgeheef"
    "gg  aggggfgfggggggg aaggggggfgfgggggggggggggggggggggggggggggggggggghggggggggggg           "
    "          gggggggggg      ggggggggggg     gggggggggggg    ggggggggggggg   gggggggggggggg  "
    "ggggggggggggggg ggggggggggggggggggggggggggggggggggggggggggggggggggggggggggggggghgggggggggg"
    "ggggggggggggggggggggghgdbfgcbbecebaeggfdggggggaaaaaafgfggggggggggggggggggggggggggg    fggg"
    "ggggggggg   eggghggggggggg  agggghgggggggg  agggfgggggggggg agggggggggggggggaggggggggggggg"
    "ggegggggggghggggggeggggggfggggggggagggggggfgggggggegggggggggggggggggggggggggggggggaggggggg"
    "gggfffgg leil                            fg                              ijhhhjhfhfggggggg"
    "               ljklkkhiigeecgggg               gggggggfafgfffgggg              hggggggfdfg"
    "ggggggg                        illlllihggeefedgegiee           lkllllkjjhgfggdeeefcd      "
    "     lilllllkjjihggffefhid           lilllllkjijjihhhhhijd           llllllljkkkijkjikkhhb"
    "           lklhjkkjljklllljljhjf           likiihihiijllklihihkg           hghhfffgiilkjkk"
    "ljlglh   gggfgggggghihihhghhhfeecegggg   gfghhgfhgikllllllkjjhgiieggfb   gggghhggjllllllll"
    "kjkkhilhjgdg   ggfiihighjllllllllllllijikhgh   ghhjihghgjikllllllllllkllljhi   gghhiidiihi"
    "klllllllllllllljik   gggghfhhiehjhlkjjjkllllllkfgi   gg gggghghiejjkjkkkllllllljhlgfeecdef"
    "efhhjijikjhihjhghdggfggfggfgffghgjilllllllijkghhhghfdggfhhhghhgigijjlllllllljljkhifhgfgege"
    "fgehffhiiiillllllllllllljihggeafgdhgghhfhhijklllllllllllllhghfgahgghgfgiiiijjkllllllllllkl"
    "iheeggfggggahhgfhhhlkkljkklllkkkkgghgg ggggghghbffihllljkklllllklihjeehfgghhhiijjkjjfihhge"
    "ccfdggggggdegggggijikjljkkijjjjhigggggggggfjgfghiijhikllllkjjjkihjhhefggggfhhhfhghijkkillk"
    "lllllljkkjiihhggeeeegeggfjiihijklllllllllkjjhghfcgfgggggebfhhgjkllllkllllllkiggeaggggfgegd"
    "ffghiiljkilllklljjhchfgggggfgfdfcfffijkklkkkllllljjieidggfgcfhiiijigihciihefeggggg gggghgg"
    "iifghijjijjjgihfiigfggggggggfhfhifjgijkjklkjikjjhkihfgfggggefffaheghihjikljklllllkljijgggg"
    "gggagagbbgegggijjlkjllljlkkkjhfgggfggdhaafecfegfijhjlllllkkkhhhggeggggggegdcffegfhkjkjlklk"
    "kikihgheggghggegcedgfihjkjiilkkkjjjhjggdbfggggfhffggihhicfggfggg        gggfhhhfhihjijigij"
    "iifegggggg   ghggghhhhhhijjjijhjjkkhhhfgggggggaeffdhehghfkkljjiljjljjihhfgggggacffaddgdfjg"
    "ghhljljjlllkhhfhgggfdaffadagdfhfhgkikjllkllkiihhggggagggcfdgcbdghfhjiilkkjkkijgieggggggggg"
    "cfcbfdigjjhklkkjllljjigghdfggggggggfheghffcggg            gggggggghfghfgghhgggggg   g     "
    "ggggghhfhhhjhjjjijfgggggggggg  gdgfgfbgighfiihikkjkkhiihggggggggbgggbfcgeegiihghgllkkkjjhg"
    "gfggggbffgeegfgcfgfghihlllllljiihgggggfgggfgfgffdghggjjilkkklijgidggfffgegbfgfbeeghijihklj"
    "lkihiiiggghhgggggggggggggggggg              ggggggggggghgfcggggg            gggggggggghigg"
    "hfeggiggggg       egggggghgfghhigjggghiihhgggggg gfgggggfgdeheigjijkhihiiiggggggggfgggggcf"
    "hgchgghjhilijiiihfhgggggggfgfgggfffhhgfhhlkljkkiiegcggggggfgggafgfhggigjkkjkkjkjihgfgggigg"
    "gg gg gggggggg                gggggggggggggggggg              ggggggggggeghhggghhggg      "
    "    ggegggfegfiighghhihfhhgggggg   gegggceafgffgghgghjhiihghfggggg gdggbfgdggfeeghgikkkjjh"
    "ghfggggggicgcfdebhegghhhjjkkkjijjfggfggggjehgghhggfghgiklllllkjkhihhheggglgggggfjjhhijllll"
    "eifhggg         iggghhhijhilllllkhffgggg        hgfgfikhhijklllllhgfhggg        hhghgfhihi"
    "lklllllhidgggg       gfggfffhhghillllllhgfdgggg      gfgggggciihjiillllhegggg        ghggg"
    "ggggfhgikllllibgggg        ggggggggfeigihklllieggg         ggggefgfhffghijlllllhihfgfhhggg"
    "ghdefgffegeefghjlllljiggfgedgehghgaefhedgfffggikllllkhgfeefeddgecfabfddbedeffgijllllljhfee"
    "fcbbeceaaafdccdeeffijllllljiigffebbbcgaabbddbcddfgfilklllllijgffeecbdfbafffecbefgegiikjllj"
    "jiiihgefcdegccgggggfegeghgiijillkihihggffegggfigggegheggiijkllghegg           hg ggggghgih"
    "jllljhhgg           hg ggggggegjkllllghgg           hg ggggggghijllllihggg         gf  ggg"
    "ghfghghllllhgggg         gg  ggggggghgiklllhgg           gg     gggggggklllegg           g"
    "g   ggggggfhijlllegg           gg      gggghehkljeg             g     g  ggghilllgg       "
    "      f     gg ggfgillleg            hi       ggggghlllhg            hk       ggggfglllkg "
    "           jl     gg ggggglllk             jl       ggggghklll             jl       gggggh"
    "lllkg            l";

constexpr std::array<std::int16_t, 216> kWeights = {
    76, 567, 515, 307, 307, 307, 307, 307,
    257, 358, 342, 4, 207, 57, 392, 307,
    200, 341, 351, 28, 242, 132, 278, 307,
    201, 360, 313, 57, 261, 163, 251, 307,
    280, 282, 291, 59, 289, 211, 213, 307,
    361, 203, 278, 50, 327, 208, 204, 307,
    395, 139, 290, 29, 382, 199, 206, 307,
    399, 74, 277, 29, 383, 177, 234, 307,
    324, 74, 244, 67, 299, 148, 295, 307,
    285, 367, 189, 289, 199, 228, 307, 307,
    308, 348, 198, 298, 189, 240, 307, 307,
    338, 312, 177, 334, 188, 229, 307, 307,
    384, 303, 180, 369, 200, 220, 307, 307,
    344, 337, 205, 370, 197, 209, 307, 307,
    349, 319, 218, 405, 201, 201, 307, 307,
    307, 318, 233, 470, 200, 197, 307, 307,
    373, 329, 77, 579, 219, 187, 307, 307,
    339, 322, 305, 198, 192, 307, 307, 307,
    460, 440, 235, 205, 272, 168, 225, 307,
    215, 463, 335, 563, 307, 307, 307, 307,
    182, 211, 301, 339, 307, 307, 307, 307,
    -69, 639, 244, 265, 307, 307, 307, 307,
    -230, 472, 520, 452, 307, 307, 307, 307,
    66, 81, 359, 362, 307, 307, 307, 307,
    38, 16, 480, 275, 307, 307, 307, 307,
    364, 329, 186, 171, 307, 307, 307, 307,
    327, 177, 191, 307, 307, 307, 307, 307,
};

constexpr std::array<std::int16_t, 1280> kWeightsByScale = {
    24, 191, 136, -389, -103, -251, 131, 0,
    1, -36, -13, -107, -27, -385, 49, 0,
    -54, -117, -80, -65, -7, -191, -53, 0,
    -136, -62, -144, -19, -157, -5, -35, 0,
    -179, -78, -81, -27, -124, 98, -43, 0,
    -121, -85, -14, -76, -150, 69, 6, 0,
    -103, -77, -27, 6, -49, 0, 3, 0,
    -58, -33, -64, 14, -61, -15, -17, 0,
    3, 308, 82, -383, -139, -105, 56, 0,
    16, -59, 56, -150, 80, -379, -29, 0,
    -125, -76, -74, -109, 59, -276, -94, 0,
    -196, -139, -76, -92, -139, -46, -109, 0,
    -203, -124, -39, -184, -204, 83, -99, 0,
    -93, -101, 5, -146, -123, 33, -63, 0,
    -153, -66, 21, -204, -96, 15, -28, 0,
    -102, -124, -13, -175, -80, -10, -26, 0,
    -3, 273, 113, -388, -151, -85, -6, 0,
    -27, 39, -23, -161, 55, -325, -62, 0,
    -113, -116, -89, -175, 42, -284, -86, 0,
    -244, -96, -46, -132, -176, -50, -75, 0,
    -174, -89, -91, -136, -79, 33, -96, 0,
    -73, -74, -23, -181, -63, 8, -65, 0,
    6, -53, -25, -204, -89, 5, -38, 0,
    -81, -77, 40, -199, -78, -25, -18, 0,
    40, 190, 112, -366, -143, -100, -39, 0,
    21, 6, -18, -202, 94, -301, -90, 0,
    -31, -81, -108, -198, 26, -293, -111, 0,
    -58, -139, -139, -175, -71, -43, -123, 0,
    -100, -107, -32, -178, -80, 27, -89, 0,
    -83, -34, 29, -242, -62, 54, -92, 0,
    -34, -24, -11, -324, -52, 5, -46, 0,
    -78, -108, 37, -272, -21, 2, -9, 0,
    86, 236, 134, -364, -170, -122, -10, 0,
    134, -156, 0, -268, 112, -316, -141, 0,
    64, -122, -133, -213, 23, -282, -109, 0,
    9, -105, -110, -206, -116, -48, -114, 0,
    -52, -98, -100, -211, -50, 16, -89, 0,
    -67, -69, 19, -264, -42, 20, -62, 0,
    -44, -55, -2, -274, -34, 5, -26, 0,
    -12, -49, 8, -225, -38, -19, -22, 0,
    192, 210, 6, -381, 17, -136, -67, 0,
    153, -220, 94, -341, 162, -315, -129, 0,
    94, -187, -131, -221, 100, -257, -139, 0,
    49, -172, -71, -204, -172, -128, -42, 0,
    30, -131, -99, -240, -53, 45, -98, 0,
    -38, -108, -43, -233, -17, 22, -51, 0,
    -30, -84, 46, -211, -18, 4, -55, 0,
    -47, -80, -5, -264, -20, 6, -5, 0,
    199, 228, 5, -190, 45, -96, -63, 0,
    37, 185, -46, -271, 288, -383, -186, 0,
    41, -307, 14, -275, 159, -351, -110, 0,
    149, -265, -31, -229, -220, -179, 7, 0,
    41, -148, -98, -240, -94, 11, -69, 0,
    -15, -123, -83, -299, -41, 21, -36, 0,
    16, -74, -39, -255, -21, 5, -34, 0,
    -18, -66, 23, -239, -30, 1, -24, 0,
    -232, 211, 83, 187, 92, 13, 40, 0,
    -325, 224, 54, -138, 270, -200, 24, 0,
    -248, -51, -138, -227, 230, -338, -170, 0,
    50, -311, -3, -243, -226, -282, 6, 0,
    79, -219, -131, -213, -76, -57, 1, 0,
    51, -129, -31, -193, -59, -4, -17, 0,
    55, -86, -49, -249, -11, 9, -17, 0,
    43, -50, 9, -126, -12, 17, -31, 0,
    -208, 83, 199, -91, -133, -101, 0, 0,
    40, 84, -203, 64, -203, -99, 0, 0,
    -5, -131, -135, -109, -264, 14, 0, 0,
    -1, -108, -149, 0, -96, -90, 0, 0,
    -22, 38, -126, 11, 34, -118, 0, 0,
    -46, 114, -66, -31, 21, -94, 0, 0,
    -48, 149, -42, -63, 7, -86, 0, 0,
    -62, 88, 43, -62, -20, -36, 0, 0,
    -43, 330, 111, -125, 1, -238, 0, 0,
    80, 192, 110, -23, -96, -91, 0, 0,
    128, -1, -128, 26, -153, -70, 0, 0,
    100, -92, -102, -42, -358, 60, 0, 0,
    -13, -138, -118, -12, -145, -53, 0, 0,
    -37, 11, -117, 11, 26, -152, 0, 0,
    -8, 105, -124, -11, 33, -136, 0, 0,
    -110, 139, -78, -47, 18, -90, 0, 0,
    137, -40, -189, 365, -27, -260, 0, 0,
    90, 54, 28, 59, -13, -244, 0, 0,
    218, 41, 46, -21, -99, -92, 0, 0,
    209, 18, -196, 21, -150, -85, 0, 0,
    41, -116, -135, 0, -235, -18, 0, 0,
    -10, -114, -135, -11, -120, -79, 0, 0,
    -60, 33, -116, 22, 6, -150, 0, 0,
    -97, 148, -96, -13, 39, -144, 0, 0,
    50, 52, 31, 257, -148, -44, 0, 0,
    -50, -153, -162, 160, 25, -162, 0, 0,
    -52, -123, 97, 77, -19, -152, 0, 0,
    172, 46, -119, -44, -70, -102, 0, 0,
    209, 16, -151, 34, -149, -82, 0, 0,
    81, 2, -118, 34, -197, -45, 0, 0,
    -16, -85, -105, -6, -136, -79, 0, 0,
    -130, 68, -140, 72, 70, -204, 0, 0,
    55, -13, -56, 188, 5, 0, 0, 0,
    -96, 91, 11, 76, -13, 0, 0, 0,
    -204, -27, -17, -8, -127, -1, 0, 0,
    -179, -37, 22, 56, -51, -173, 0, 0,
    184, 0, -118, -41, -72, -130, 0, 0,
    212, 24, -47, 27, -145, -86, 0, 0,
    113, 79, -97, 20, -183, -56, 0, 0,
    -55, -18, -106, 96, 21, -164, 0, 0,
    -105, -77, -18, 71, 0, 0, 0, 0,
    -206, -208, -16, 114, 0, 0, 0, 0,
    102, 17, -15, 152, 0, 0, 0, 0,
    -305, -37, 61, 175, -228, -126, 0, 0,
    -41, 43, 93, -29, -47, -93, 0, 0,
    244, -93, 71, 27, -80, -137, 0, 0,
    312, 79, -104, 9, -135, -83, 0, 0,
    -37, 20, -94, 123, -77, -111, 0, 0,
    14, 23, 0, -2, 0, 0, 0, 0,
    -60, -37, 0, 25, 0, 0, 0, 0,
    -258, -208, 0, 53, 0, 0, 0, 0,
    -113, -63, -10, 52, -122, -8, 0, 0,
    -154, 147, 55, 277, -171, -57, 0, 0,
    -58, 179, 46, 123, -37, -125, 0, 0,
    305, -12, 88, -54, -72, -149, 0, 0,
    58, 10, -86, 153, -119, -95, 0, 0,
    -28, -42, -106, 18, 0, 0, 0, 0,
    -52, -15, -202, 19, 0, 0, 0, 0,
    -109, 76, -153, 75, 0, 0, 0, 0,
    -79, 83, -275, 48, -4, 0, 0, 0,
    -139, -14, -331, 96, -73, -26, 0, 0,
    31, 188, -251, 190, -169, -98, 0, 0,
    141, 337, -333, 146, -98, -86, 0, 0,
    98, -116, -77, 241, -73, -117, 0, 0,
    262, 129, -139, -116, -159, 0, 0, 0,
    59, 11, -20, -149, -110, 0, 0, 0,
    -12, -8, 27, -54, -140, 0, 0, 0,
    27, 49, -33, -127, -87, 0, 0, 0,
    -26, 32, -5, -86, -104, 0, 0, 0,
    5, -66, -21, -103, -82, 0, 0, 0,
    -11, 6, -40, -85, -106, 0, 0, 0,
    -22, -73, -9, -88, -73, 0, 0, 0,
    171, 216, -106, -144, -158, 112, -174, 0,
    254, 130, -150, -77, -281, -17, -79, 0,
    251, 158, -120, -58, -135, -110, -74, 0,
    200, 145, -105, -65, 4, -160, -59, 0,
    130, 117, -59, -101, 61, -186, -68, 0,
    67, 95, -21, -126, 25, -172, -75, 0,
    59, 83, -13, -100, 7, -182, -75, 0,
    60, 113, 17, -154, 66, -188, -81, 0,
    293, 10, -175, -214, 0, 0, 0, 0,
    195, 43, -162, -180, 0, 0, 0, 0,
    90, 59, -112, -165, 0, 0, 0, 0,
    64, 74, -106, -131, 0, 0, 0, 0,
    32, 9, -88, -111, 0, 0, 0, 0,
    -33, -41, -90, -77, 0, 0, 0, 0,
    -10, -103, -62, -97, 0, 0, 0, 0,
    -38, -77, -53, -66, 0, 0, 0, 0,
    140, -42, -37, 0, 0, 0, 0, 0,
    108, -95, -116, 0, 0, 0, 0, 0,
    122, -34, -134, 0, 0, 0, 0, 0,
    180, -61, -140, 0, 0, 0, 0, 0,
    159, -103, -60, 0, 0, 0, 0, 0,
    44, 61, -109, 0, 0, 0, 0, 0,
    -190, 16, -37, 0, 0, 0, 0, 0,
    -98, -161, -54, 0, 0, 0, 0, 0,
};

constexpr Confidences kConfidences = {{
    {{{256, 211, 371, 182, 180, 154, 193, 293},
      {256, 262, 309, 194, 317, 317, 296, 313},
      {256, 215, 339, 297, 236, 210, 266, 315},
      {256, 256, 256, 256, 256, 256, 256, 256},
      {256, 256, 256, 256, 256, 256, 256, 256}}},
    {{{256, 145, 352, 252, 237, 183, 189, 163},
      {256, 211, 335, 269, 219, 197, 208, 240},
      {256, 169, 283, 243, 232, 215, 184, 184},
      {245, 177, 178, 175, 187, 211, 214, 205},
      {256, 256, 204, 193, 205, 205, 204, 174}}},
    {{{256, 289, 326, 376, 245, 196, 145, 114},
      {256, 256, 140, 229, 256, 249, 277, 178},
      {244, 249, 195, 136, 119, 119, 143, 165},
      {254, 184, 177, 165, 187, 207, 211, 191},
      {256, 256, 256, 256, 256, 256, 256, 256}}},
    {{{256, 256, 256, 234, 251, 253, 235, 219},
      {256, 256, 256, 240, 253, 277, 222, 230},
      {256, 256, 230, 207, 203, 181, 216, 245},
      {256, 256, 256, 256, 256, 256, 256, 256},
      {256, 256, 256, 256, 256, 256, 256, 256}}},
    {{{256, 256, 356, 342, 279, 276, 289, 270},
      {256, 256, 256, 314, 234, 292, 311, 281},
      {195, 231, 207, 217, 267, 303, 286, 274},
      {187, 209, 234, 258, 275, 221, 195, 252},
      {256, 150, 132, 134, 144, 190, 242, 301}}},
    {{{256, 180, 193, 237, 211, 203, 233, 248},
      {256, 182, 343, 294, 240, 277, 328, 176},
      {258, 149, 308, 266, 241, 256, 304, 296},
      {256, 221, 317, 229, 217, 319, 319, 274},
      {256, 256, 256, 256, 256, 256, 256, 256}}},
    {{{256, 256, 256, 275, 283, 302, 242, 259},
      {256, 256, 256, 251, 230, 217, 256, 240},
      {256, 256, 256, 256, 256, 256, 256, 256},
      {256, 256, 256, 256, 256, 256, 256, 256},
      {256, 256, 256, 256, 256, 256, 256, 256}}},
    {{{256, 256, 256, 257, 249, 262, 246, 261},
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
