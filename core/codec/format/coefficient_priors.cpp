// SPDX-License-Identifier: MIT
// Made by tests/bench/fit_priors.cpp.
#include "core/codec/format/coefficient_priors.h"

#include <array>

namespace mocapress::runtime {
namespace {

// clang-format off
constexpr std::string_view kContexts =
    "4ADFHJNVEGHJKMPVIJJLMORVJLLMOPSWMOOPQRUXPPQRSTVZSUSTUVY]]^YZYY]a4@CEGJMVFGHIKMOUJJKKMNQVKL"
    "LMNPRWMOOPQRTXQPRRSTVZVVVVVWY^X^_^]^_c7@DFGJOYGGHIJLOVLJKLMNQVKLLMNPRWNOPPPQTXSRSRSTVZVTXW"
    "WWY^^eXZ]Z^d@BFGILP[IFIIJLOVOKLMMOQVOMMNOPRWSOPPQRTXWUTSSTVZ_WWWWWY^fd]Y^__eGCHIJMR]JHIJLN"
    "QVQLLMNPSXPMNNOQSXTPPPQSUYYSSTTUW[_YVYWXY^jda^_^_eKFKLMPUbKIKKMORZRKMNOQTZQMNOPQT[TOQQRSUZ"
    "YSTUTUW[`YWXXXZ_iaba_a_ePFMNOSXfLJKMNPSZTMMNPRUYRNOOPSU[UQPRRSV]XRTTTUW]^XXXXYZ_h[ab`__eWK"
    "PRSW]iMMNOPRW^VONPQTW[TNPPQTW]UQRSSTW^YTVVWVX^^ZXZZZ[_hh__`aaf1;>@CFJUABCDEHKSHFGHIKNUJIII"
    "KLPUPMMMNPRXWRORRRUY`RUXUXX]h`bXY_af6?BCEHKNDDEEFHKQIGGHIJNOHIGHJJNSLLLLKMORSTONMORUTUNVRU"
    "TW      US8ADEFILQEFFGHJLTIHIJJLOQIHIJKMOTKKLLMMPTPQOMOPRVSSPQSRVY   TX[Y[:CEGHJMRFFHHIKNS"
    "JIJKLMPSJJKLLNPTMMMMNOQURPPOPQSWSURRTRUYL`XT`Y[^?DGHJLOUHHIJKLOTMKKLMNPTLLLMNOQUNNNOPQRVRQ"
    "QQQRTWVUUTSTVZZ`a^][Y`EEIJKNQXJIJKMNQUOKMMNPRVOMMNOQSWQOPPQRTWVRRSSSVXZWVVVVX[a^a^`[[_IFKL"
    "MOS]KJKLMORWRLNNOQSXPNOOPRTXSPQQRSUYXSTTTUWZ_WWWWXY]g`][]^^bMGMMNPU_MKMMOPSYSMNOPRUYRNPPQS"
    "UYUQRRSTVZXRUVUUW[_WWXWXZ^i_d]^^_eUIOOPSXdOMNOPRUZVOPPQSV[UQQRRTW[WSSSTUW][UVVVWY]`ZXZZZ[_"
    "jgZ_`_`eA    adg     Haeb   UOe`e   aWWhY  aV_]cl  XRU[ccbbc]]]cj c`afcj-,68:<?ACFHKNPSUWZ"
    "]_abeglhka    .+579=>ACEHJMPRUWZ]_acegills_   1-57:=?ADFIKMPRUWZ]_acegjmqwn   7.78;?@CEHJL"
    "NQSVXZ]_acehkoou{   >19;=ABEGIKMOQTVX[^`bdghknpv|   F8=<?CDFIJLNPRTWY[_`cdfjkoqwx   O=C?DF"
    "HIKLNOQSUWY]_acegikoqww   fLJOLMMOPQRRSUVY[^`bdfgimlpsp   EJJIIJROSZGAEEFFIJMQJCFHHINMOTMH"
    "HIJJNNPSPKKLLMPOQUXZPOOPTQSVWP PVS[TUX   LUVdWWZ   V``hXZ^      tZYdBDCBDFRKOW=<B@ABDEILDD"
    "DEFDJHLPHECDEEKHKPKGHFFHMJLPTVJOLKQLNRa  NPPXOPS    GS^RSV   OPVdVVY      l[V`FA;:>ASIKU=;"
    "F><<DCELBFBEDDJFHOGA;@FELEHN=>GEBDMFHNP[=MFIPGINP  GPOUKKP    RO]OOR     V`SSV      gTT]K@"
    "  AASHIS  GGG7BBFK>JJ8<7JDEKF  ;IHLGGKE  D<GMDEL<Q ;9@MBEK    DMRGGL     QWLJN      ]QPR  "
    "    dVSY     @RFHR      =JLM     ?N;AK    :>K<BK   TF@MDIK     NM@EK     >NECJ     SSIGL  "
    "    WQLN      `ZPV      R6EQ        RA      L?FH      L=@J     QK<4I     ?MIAJ      LEBJ  "
    "    NECJ      SMIK      [RNS      Q BQ        @B      L  H      J  G      KFEK      I8?I  "
    "    L9KJ      L=EJ      N>CI      XAMQ      Q  P                I  K      L  G      K  H  "
    "    K  J      J 9I      K FI      L >J      R ?OR@DBEHFHIJKLNPRUWY]_acegjmpvx   V5A>BGGHIH"
    "IIIKMORTWY[_acfilps   U?=C9HJKMLLKIHIKMORTWY[_beilq   U    ELKNNPOLKIIIKMORUWZ^adhl   S   "
    " >EDKOPPMMLJIIJKMQSVX]`di   Q     OIMLQRNKLKKJIIJMNQTX[ad   Q       KKQRPMKMKJJIIMKMPSW[` "
    "  Q       HFPQPOKKMLKKKPJMMOQST                                   M?>FHHFGHHHIJKLMNNOOOOOO"
    "OOOOO   N?=QLHIJIIIIIIJKLMNNNOOOOONPO   L    KGGIHKJIIIIJKLMNOOOOOOPM   L    VLMJLLKLIJIII"
    "JKMMNNOOOOO   K      IJKJLIKIJJIIIJKLNNNNOP   L       EGMMHLHKIIIIIJKKMNNOP   L       PFKM"
    "KLJJJHJJIKJJKLLMM                                                                         "
    "          K       GJ      GHKJ    HHIKL   JJJKLMN KKLLLMN LLLMMMNOLMMMNNNNLLMMNNOOJKLMNNNO"
    "L       GH      FGJK    GIHJK   HIIIJLM IIJJJKM JKKKKLMOLLLLLMMNLMLMMMNNKLLLMMNOL       II"
    "      DFJH    HFGKJ   FFGHHJK GHHIIIL IIJIJJLNIKJKKKLNLNLLLLMNJLNLLMNOL       GJ      IHKI"
    "    MBHJJ   HIGGIKJ CDGGHIK IHIIJIJLHGIHJJJMLJLKKKKMMKKLNLMNL       LK       UJB     AIKI "
    "  B=JKIJL 8BEIKGJ BPEGCGIKJIIIGJIKGDKIIJILHLJJKKKML        C        GN      IJI     MLLIM "
    "M E=@FI  HHLEEJJ>A<@HEFJM?JFGGIJMCHKKIJLL                 N        IG      RIJJ    B>LI   "
    "  O@HJ    M=FJ   =@EDILOFMJHIL                                OLKLNOONSMMMNOOYONMLMOOLJPMM"
    "NOPMOLMLMNOOKJMMMNOOLNLLLMONN MLLMOOJ NLLMNON NMMMNOK KLKLMNI LMLMNMOQNOOMOQONNLNNMMNLQRPQ"
    "RPPQPOPNOOMOQOMMKNNMMMLQSQQRPPRPOOOOPMOQNKLJNNLLMKRSRRRQQRPPNPNPNPPNOMKMMMMMKPSRPRQPRQPNPM"
    "ONPPOOMLNMMOMLORRORQPQQPMRMONQPPPMNNNNONMPPQNPQPPQOLROOMQPQPNONNNONOPOPOOPPPPONQNONPQRPOQM"
    "PNOORONOMLOPOOOOOPOOMNNLQPQPMNPRLNNJRMNPNMQPQTNNSRRPLPPTLJJLPPPNMNPQ,KKKLQW`i|*CDGHLQXe|0@"
    "BDHLRYc|4@CFJNM[hz7CFGLQK_f|8HHJMQK_hy8HPNPQJ^e{; HRQSK`gw-DCCEI=QRfINQQRVZ^f|0DDFHLGYd|9I"
    "HIJNHWWWMQQQSW^fmz>LLMPSS_j|                    3EB@EJUS^|                                "
    "                  . >>>IR[d|+BDHLTZcy|,LPSX_h|||                                        . "
    " >BFMTa|* <@EJQZj|(BAFIOVej|(DHLQWdq||                              9   KNSYi|/  BDIOX`|+ "
    ">?DJQZh|*;BFKPXcm|'@DHNW`|||                    =    XJknv:   NPU[k|-  BFJQXet- BDHMT`j|-@"
    "CFMR]cj|,@DINUak||                    ?    WI_ho9   QQV^m|1  DGLR[`|0 HGJRXh||1DEIOV]h||0B"
    "FKRWd{z|                    =    XJ^f|9   NPT[eu5  KKPVbl|4 HIKQZp||3BHJR[myz|3MJMW_rrs{  "
    "                  >    ]J]`n7   NOU]c|7  OOOW^j|5 PNRYbyz|7HQPVoqrs|                      "
    "        >    VKgp|:   OQU^eu9  SUYar{|4 HMSZprr|                    QUPP#                 "
    "          E>)                             MWWVTSRRRQQPOMLOMFE<            JSTSSRQQQPPOMLJK"
    "LMSH            Zgkd__^ZUSQRRSRROJFA@           W[ZYYXXXWRQRRQTPRKGDF           TU[N&     "
    "      QUOP#                                                                               "
    "                                                                                          "
    "                                                                  G&              E>)     "
    "                                                                                          "
    "                                                                                          "
    "                                                    NWVUTSRRRQQPONMN@LKLKKIFE       RNMMJH"
    "NII?      XVMNNKHIHN@     `]WMLIKINFG     ed_XKIJIJMMK    ifd_WIHILFKI    pjfd^VHHHKHF    "
    "qrkfc_VHHJLAI   vxokhe^WHGIKI   w|qpkgd^WHIKL>  x||vqnje_WHGJF  u{{{opmhe`WFHBC yyyyvupmlh"
    "_XFEA wwwwwwkmjgj`VB< vvvvvvvvkiqi]VE=KSTSRRQQQPPOMLJMBKLMMLFLJH      OONKNMIJFL      WTOM"
    "LOQHJ@      ^ZVOLMLPFJG     a`[UMKNLPDB     ee`[UMKMIOJI@   jge`^ULKNHOD>   rmfea]ULLNHQMI"
    "  uolfd`]TKLLJMG@ |xqldd_[ULILHNO ||snhic`[TKINMKDzzzuzigda[UKHMJHxxxxxxkneb]TIFQNuuuuuuui"
    "bd_ZUGJOsssssssssmf`dVICZgkd__^ZUSQRRSRO                                                  "
    "                                                                                          "
    "                                                                                          "
    "          W[ZYYXXXWRQRRQTO                                                                "
    "                                                                                          "
    "                                                                                      PYTQ"
    "#           TOPR#           TXLN#           ZWLQ#           QVRK(           LPNC8         "
    "  SUD-            KQ2=            IP&             HI.             NN68            JU-     "
    "        &               8                                               C>,             L:"
    "0             ER4             F-              +                                           "
    "                                                                                          "
    "                                                                          HUVUTRSSSRQQPNON"
    "NTRSOMLOPMMYNUSMQUTRQLLILNNI    RWUTRQLKIJONI   SXVTQPPLJHLQOP  UYXVTPOPLKJLKJ  W]YWVSPOQM"
    "KGNH? Wb[ZWVSOOQMHLLB?Ve^ZYWVSOPQLIB= Uda[ZXXUSOQRKG< Tce`[ZXWUSOOPIH;Tldh^ZZXWUSOOOCITnnc"
    "kbZXXWTQMIJMUvorah`ZXVVSQJB9Pf||iee`YWVUUPMJJTTTSRQQQPOOMLKLBIKLKNMMIG      OKLJHJNKQQ@   "
    "  TQMLLFJOLM      YURMMJKFMNTP    ]XVRMLJJFPJ     _[WVQMKIKEJO    aaZWURMKJKDKQ   a``ZWUQL"
    "KIKJB   ccb_[XUQLLKHB   iiec`[XVQLJJHN  ngkec_^XVQLLJIF vxhhee`[YWQKJJIOqwkkifd_]YXQLIENxx"
    "xlfdeb`YYVPL@ wkwiniaab[XVVTKG||n`XXVTSQQRQQQMlecfggd_WTSRSTRPcccccccccYG                 "
    "    RccccccOIN      Sjjjjjj]JJB     S`llllllZHLB    RammmmmaYTGHE   Tnnnnnn[TQRIHD  Xppppp"
    "peRMMTFJ> X_qqele_`RKNQIIFV^hlqca_[^SLPSFEYp`^ppe`_]_OMQUJXooZgooed^]bQMQOXooo]aooe`^a`RMO"
    "YouuuifjljfgcdWPW]ZZZYWXWSQRRQTPLQWPNO?         TPYSKK          VWRQNJT?        XXVXQPMQ= "
    "      Z_cUWURJO=      WXZ]SSSSJN=     _]XUYVTSLJN?    _c[YUYWUSLJQ=   lhb[`Y^[KSLJK@  rhhm"
    "dcc`_COMGQ@ rrrjjec^[[ESNGJ rrrrjqdm]ZVEVJE qqqqqknfl]ZVEZQGppppppjkdg]^XEVIuuuuuuunuilg^]"
    "UO                <0              MS,             JYVC8           OaUL(           gWIR'   "
    "        U^LM#           SMQU#           PYTQ#           USNO&           SSKR'           UV"
    "OO'           UPM@6           NL?8            |WF-            PO16                        "
    "                                                    +               E.              Hk4   "
    "          L$              C>,             L<0             C8              K8              "
    "                                                                                HUVUSRSSSR"
    "QQPNONNURSPMLNNMMWNTTLQUTRRMMKNKKH    RWUTRRMLILNOK   SXVTRPQMKIMKPP  UYXVTPPPMMKNKH  W]YW"
    "VSPPQMLHOE? Wb]YWVSOPRMKLKF>Ve^ZYXVSOPRLJDE Udb[ZXXUSOQRKH< Tce`[ZXXUSOPPIG9Tlch_ZYWXTSOOP"
    "CITnnbkbZXXWTQMIKMTvoraj`ZXVWSQKB:Pe{{hed`YWUUUPMJ                GPRRRRQQQQPOMMJMLPPPONMM"
    "LPQMQP@TPSQPONMKIHHRU   RUSRPNNMMID@    TXUSQPNMNLIH?   U[XURQOMNNLIA>  V^ZWTRQONMNKIG= Wb"
    "^ZWTRQONMMIGD Vbc]YWTRPOMLMJD?U`b^WZWSQQOMJJFAUa`^^WYWSRPOKIJKUdaa__XXVRQPNLGLUedca][WXVQQ"
    "NMJBSfqc^_^]TXVRNLLES^{kgc_][WUTPNON||n`XXVTSQQRQQQMlecfggd_WTSRSTRPcccccccccYG           "
    "          RccccccOIN      Sjjjjjj]JJB     S`llllllZHLB    RammmmmaYTGHE   Tnnnnnn[TQRIHD  "
    "XppppppeRMMTFJ> X_qqele_`RKNQIIFV^hlqca_[^SLPSFEYp`^ppe`_]_OMQUJXooZgooed^]bQMQOXooo]aooe`"
    "^a`RMOYouuuifjljfgcdWP[^YXVUTSSRRRQOSLWZ____^^YSQSRRTPUXZTZYccXMMTRRWLUUYVW]agVOH@    UZW^"
    "`XY`XOPKG  OUYXU]YVW]SORKD  T_^WYYWVUYPQOG TT_`[ZXVWVSUPPQJ TbhYWZXUYWSWTMXGT[i`[XZWUVTVWQ"
    "TMT]Wh_[WYWXXXVZTPSeWegqYYXWZZWTYPScpYjgi_SVWZWZURSdppXlo__WWZYYTQRennn[]jgXRZUXUSRcppppa["
    "c^^UUWTR RKN=                            KB                              OMMMMLLLLMLMKKJOJ"
    "LK             OLLLLLLLLLKKJKHFKGL             UQPONNNNMLKLKMJMKJD@            RMLMMMMMMLK"
    "KLKMJLHCJ           ";

constexpr std::array<std::int16_t, 216> kWeights = {
    -949, 923, 1132, 307, 307, 307, 307, 307,
    188, 290, 310, -100, -152, 405, 307, 307,
    240, 163, 343, -18, -202, 419, 307, 307,
    285, 83, 379, -51, -226, 422, 307, 307,
    290, 24, 463, -133, -178, 375, 307, 307,
    371, -50, 484, -257, -123, 331, 307, 307,
    463, -153, 539, -403, -102, 310, 307, 307,
    549, -243, 596, -416, -189, 431, 307, 307,
    463, -141, 605, -421, -234, 534, 307, 307,
    136, 450, 89, 80, 143, 307, 307, 307,
    212, 393, 67, 105, 190, 307, 307, 307,
    215, 326, 79, 139, 204, 307, 307, 307,
    196, 290, 77, 145, 221, 307, 307, 307,
    161, 237, 61, 173, 213, 307, 307, 307,
    142, 185, 41, 199, 235, 307, 307, 307,
    131, 121, 59, 225, 251, 307, 307, 307,
    313, -154, 139, 287, 264, 307, 307, 307,
    386, 202, 103, 134, 307, 307, 307, 307,
    511, 597, 149, 185, 97, 192, 307, 307,
    -902, 1008, 136, 765, 307, 307, 307, 307,
    -148, 324, 181, 657, 307, 307, 307, 307,
    -273, 886, 625, 81, 307, 307, 307, 307,
    -979, 803, 871, 740, 307, 307, 307, 307,
    510, -145, 468, 468, 307, 307, 307, 307,
    243, -551, 827, 831, 307, 307, 307, 307,
    434, 138, 137, 307, 307, 307, 307, 307,
    108, 168, 307, 307, 307, 307, 307, 307,
};
// clang-format on

}  // namespace

std::string_view context_priors() {
  return kContexts;
}

std::span<const std::int16_t> weight_priors() {
  return kWeights;
}

}  // namespace mocapress::runtime
